// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "ReprojectionTable.h"

#include "brickwall/channels/RigFiles.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/render/LegendText.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"
#include "brickwall/plugin/RigViewer.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace brickwall::test {
namespace {

/// The left eyes of cave5, each in a window of its own.
Rig caveOf(int size)
{
    Rig rig = loadRig("cave5");
    std::erase_if(rig.channels, [](const Channel& channel) { return channel.stereo != StereoMode::left; });
    std::vector<Window> windows;
    for (Channel& channel : rig.channels) {
        windows.push_back(rig.windows[channel.window]);
        windows.back().width = windows.back().height = size;
        channel.window = int(windows.size()) - 1;
        channel.viewport = {0, 0, size, size};
    }
    rig.windows = windows;
    return rig;
}

Scene sceneOfSample(const std::string& sample, const Executor& executor)
{
    Progress silent;
    const auto data = openDataSet(sample);
    const Model model = data->load(std::vector{data->defaultField()}, executor, silent);
    const Field& field = model.fields.front();
    Scene scene;
    auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, silent));
    scene.field = std::make_shared<PaddedField>(padField(field, model.bricks, *regions, executor, silent));
    scene.regions = std::move(regions);
    scene.transferFunction = chooseTransferFunction(model, field).tf;
    scene.worldFromVoxel = model.worldFromVoxel;
    return scene;
}

/// A CAVE with a sample in it, and its windows.
class Cave
{
public:
    Cave(const std::string& sample, int size)
        : scene_(sceneOfSample(sample, executor_)),
          renderer_(scene_, executor_),
          rig_(caveOf(size)),
          worldFromRoom_(worldFromRoom(rig_, worldBounds(scene_).lower, worldBounds(scene_).upper)),
          shown_(rig_)
    {
    }

    const Rig& rig() const { return rig_; }
    MultiChannelDrawer& drawer() { return shown_.windows.drawer(); }

    /// The eye at its place plus an offset.
    void look(const vec3d& offset)
    {
        Rig moved = rig_;
        moved.viewers[0].roomFromHead[3] += vec4d(offset, 0.0);
        views_ = viewsOfRig(moved, worldFromRoom_);
        shown_.windows.show(views_, glm::inverse(worldFromRoom_));
    }

    std::vector<Frame> render() const
    {
        std::vector<View> views;
        for (const ChannelView& view : views_.views)
            views.push_back(view.view);
        Progress silent;
        return renderer_.render(views, RenderSettings{}, silent);
    }

    /// As the images for where the eye is now.
    void publish(const std::vector<Frame>& frames)
    {
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const int view = shown_.windows.channels().indexOf(views_.views[i].channel, views_.views[i].eye);
            shown_.write(views_.views[i], frames[i]);
            drawer().updateMatrices(view, drawer().modelMatrix(view), drawer().viewMatrix(view),
                                    drawer().projectionMatrix(view));
        }
        drawer().swapFrame();
    }

    /// Pictures of all channels, each the only one of its window.
    std::vector<osg::ref_ptr<osg::Image>> draw()
    {
        const auto windows = shown_.draw();
        std::vector<osg::ref_ptr<osg::Image>> pictures;
        for (const ChannelView& view : views_.views)
            pictures.push_back(windows[rig_.channels[view.channel].window].left);
        return pictures;
    }

private:
    Executor executor_;
    Scene scene_;
    Renderer renderer_;
    Rig rig_;
    mat4d worldFromRoom_;
    ShownRig shown_;
    RigViews views_;
};

struct Pose
{
    double distance;
    vec3d offset;
    std::vector<Frame> truth{};
};

std::vector<Pose> posesOf(Cave& cave)
{
    std::vector<Pose> poses;
    for (const double distance : eyeOffsets) {
        for (int axis = 0; axis < 3; ++axis) {
            Pose pose{distance, vec3d(0.0)};
            pose.offset[axis] = distance;
            cave.look(pose.offset);
            pose.truth = cave.render();
            poses.push_back(std::move(pose));
        }
    }
    return poses;
}

/// White where an image has something.
std::vector<Frame> masksOf(std::vector<Frame> frames)
{
    for (Frame& frame : frames) {
        for (vec4f& color : frame.color)
            color = color == vec4f(0.0f) ? color : vec4f(1.0f);
    }
    return frames;
}

void compareColors(WarpError& error, const osg::Image& picture, const Frame& truth, const vec3f& background)
{
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            const Rgb found = pixel(picture, x, y), want = composed(truth, x, y, background);
            for (int i = 0; i < 3; ++i)
                error.squared += double(found[i] - want[i]) * (found[i] - want[i]);
            error.components += 3;
        }
    }
}

void compareCover(WarpError& error, const osg::Image& picture, const Frame& truth)
{
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            if (truth.color[truth.index(x, y)].a < 0.02f)
                continue;
            ++error.seen;
            error.holes += pixel(picture, x, y)[0] < 64;
        }
    }
}

void compare(WarpError& error, Cave& cave, const Pose& pose, bool cover)
{
    cave.look(pose.offset);
    const auto pictures = cave.draw();
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (cover)
            compareCover(error, *pictures[i], pose.truth[i]);
        else
            compareColors(error, *pictures[i], pose.truth[i], cave.rig().background);
    }
}

/// Parts of pictures as tiles, three in a row, each with a line of text above.
class Tiles
{
public:
    Tiles(int size, int left, int count) : size_(size), left_(left)
    {
        image_.width = columns * (size + gap) - gap;
        image_.height = (count + columns - 1) / columns * (size + label);
        image_.rgba.assign(std::size_t(4) * image_.width * image_.height, 255);
    }

    void add(const std::string& name, const std::function<Rgb(int x, int y)>& color)
    {
        const int left = number_ % columns * (size_ + gap), top = number_ / columns * (size_ + label) + label;
        drawText(image_, left + 2, top - label + 3, 1, name, vec3i(0));
        for (int y = 0; y < size_; ++y) {
            for (int x = 0; x < size_; ++x) {
                const Rgb c = color(left_ + x, size_ - 1 - y);
                for (int i = 0; i < 3; ++i)
                    image_.rgba[image_.index(left + x, top + y) + i] = std::uint8_t(c[i]);
            }
        }
        ++number_;
    }

    const Image& image() const { return image_; }

private:
    static constexpr int columns = 3, gap = 4, label = 14;
    Image image_;
    int size_;
    int left_; ///< of what is shown of a picture; from its bottom on
    int number_ = 0;
};

Image sideBySide(Cave& cave, const Pose& pose)
{
    const Frame& truth = pose.truth.front();
    const int size = 7 * truth.width / 10, left = truth.width - size; // the lower right corner
    const auto trueColor = [&](int x, int y) { return composed(truth, x, y, cave.rig().background); };
    const auto errorOf = [&](const osg::Image& picture) {
        return [&](int x, int y) {
            Rgb error = trueColor(x, y);
            for (int i = 0; i < 3; ++i)
                error[i] = std::min(255, 4 * std::abs(error[i] - pixel(picture, x, y)[i]));
            return error;
        };
    };
    cave.look(pose.offset);
    cave.drawer().setViewsToRender(MultiChannelDrawer::Same);
    Tiles tiles(size, left, 9);
    tiles.add("true", trueColor);
    osg::ref_ptr<osg::Image> asIs, mesh;
    for (const auto& [name, mode] : comparedModes()) {
        cave.drawer().setMode(mode);
        const osg::ref_ptr<osg::Image> picture = cave.draw().front();
        tiles.add(name, [&](int x, int y) { return pixel(*picture, x, y); });
        (mode == MultiChannelDrawer::AsIs ? asIs : mesh) = mode <= MultiChannelDrawer::ReprojectMesh ? picture : mesh;
    }
    tiles.add("AsIs: error x 4", errorOf(*asIs));
    tiles.add("ReprojectMesh: error x 4", errorOf(*mesh));
    return tiles.image();
}

} // namespace

double WarpError::psnr() const
{
    return 10.0 * std::log10(255.0 * 255.0 * double(components) / squared);
}

std::vector<NamedMode> comparedModes()
{
    std::vector<NamedMode> modes{{"AsIs", MultiChannelDrawer::AsIs}};
    modes.insert(modes.end(), warpingModes.begin(), warpingModes.end());
    return modes;
}

WarpErrors measureWarp(const std::string& sample, int size, Image* picture)
{
    Cave cave(sample, size);
    const std::vector<Pose> poses = posesOf(cave);
    cave.look(vec3d(0.0));
    const std::vector<Frame> frames = cave.render();
    WarpErrors errors;
    for (const bool cover : {false, true}) {
        cave.look(vec3d(0.0));
        cave.publish(cover ? masksOf(frames) : frames);
        for (const auto selection : {MultiChannelDrawer::Same, MultiChannelDrawer::MatchingEye}) {
            cave.drawer().setViewsToRender(selection);
            for (const auto& [name, mode] : comparedModes()) {
                cave.drawer().setMode(mode);
                for (const Pose& pose : poses)
                    compare(errors[{selection, mode, pose.distance}], cave, pose, cover);
            }
        }
        if (picture && !cover)
            *picture = sideBySide(cave, poses[6]);
    }
    return errors;
}

} // namespace brickwall::test
