// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/ChannelPass.h"

#include "brickwall/plugin/ViewportQuad.h"

#include <osg/GLExtensions>
#include <osg/Program>
#include <osg/State>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

/// Of the program that is being drawn with; names that it does not have are passed over.
class Uniforms
{
public:
    explicit Uniforms(const osg::State& state)
        : program_(state.getLastAppliedProgramObject()), gl_(state.get<osg::GLExtensions>())
    {
    }

    explicit operator bool() const { return program_ != nullptr; }

    void set(const char* name, double value) const { gl_->glUniform1f(locationOf(name), GLfloat(value)); }
    void set(const char* name, double x, double y) const { gl_->glUniform2f(locationOf(name), GLfloat(x), GLfloat(y)); }
    void set(const char* name, const osg::Matrixd& matrix) const
    {
        GLfloat values[16];
        std::copy_n(matrix.ptr(), 16, values);
        gl_->glUniformMatrix4fv(locationOf(name), 1, GL_FALSE, values);
    }

private:
    GLint locationOf(const char* name) const { return program_->getUniformLocation(std::string(name)); }

    const osg::Program::PerContextProgram* program_;
    const osg::GLExtensions* gl_;
};

} // namespace

ChannelPass::ChannelPass(osg::ref_ptr<DrawerView> view, osg::ref_ptr<const ChannelSource> channels, int channel,
                         DrawerPass pass, const Drawing& drawing)
    : view_(std::move(view)), channels_(std::move(channels)), channel_(channel), pass_(pass), drawing_(drawing)
{
    if (isWarped(pass_))
        shapeWithoutBounds(*this);
    else
        shapeAsViewportQuad(*this);
    osg::StateSet* state = getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    state->setTextureAttribute(drawerState::colorUnit, view_->colorTexture());
    state->setTextureAttribute(drawerState::depthUnit, view_->depthTexture());
    refresh();
}

void ChannelPass::refresh()
{
    if (!isWarped(pass_) || !view_->grid)
        return;
    const PixelGrid& grid = *view_->grid;
    osg::PrimitiveSet* shape = grid.mesh() ? grid.mesh() : grid.points();
    if (getNumPrimitiveSets() == 1 && getPrimitiveSet(0) == shape)
        return;
    removePrimitiveSet(0, getNumPrimitiveSets());
    setVertexAttribArray(drawerState::pixelAttribute, grid.vertices());
    addPrimitiveSet(shape);
}

/// Whether the image is seen from where it was rendered for: no pixel would move by more than a hundredth of its width.
/// Depth does not count, since near and far are not known before the end of the traversal.
bool ChannelPass::isAtRest(osgUtil::CullVisitor& cull) const
{
    constexpr double tolerance = 1e-5;
    const osg::Matrixd moved =
        view_->modelFromImage() * model_ * *cull.getModelViewMatrix() * *cull.getProjectionMatrix();
    for (int row = 0; row < 4; ++row) {
        for (const int column : {0, 1, 3}) {
            if (!(std::abs(moved(row, column) - (row == column ? 1.0 : 0.0)) < tolerance))
                return false;
        }
    }
    return true;
}

bool ChannelPass::isDrawnBy(osgUtil::CullVisitor& cull) const
{
    if (!view_->front().color || !channels_->isDrawnBy(channel_, cull))
        return false;
    // At rest every mode gives the picture of AsIs, which is drawn faster.
    const bool warped = view_->canReproject() && view_->grid && !(drawing_.alone && isAtRest(cull));
    if (isWarped(pass_) || warped)
        return isWarped(pass_) && warped;
    return view_->front().hasDepth == (pass_ == DrawerPass::asIs);
}

void ChannelPass::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cull = visitor.asCullVisitor();
    if (!cull || isDrawnBy(*cull))
        osg::Geometry::accept(visitor);
}

osg::Matrixd ChannelPass::drawnFromImage(const osg::State& state) const
{
    const osg::Matrixd& projection = state.getProjectionMatrix();
    if (isWarped(pass_))
        return view_->modelFromImage() * model_ * state.getModelViewMatrix() * projection;
    return view_->canReproject() ? view_->eyeFromImage() * projection : osg::Matrixd::identity();
}

void ChannelPass::drawImplementation(osg::RenderInfo& info) const
{
    const osg::State& state = *info.getState();
    const Uniforms uniforms(state);
    const osg::Viewport* viewport = state.getCurrentViewport();
    if (!uniforms || !viewport)
        return;
    uniforms.set("brickwallDrawnFromImage", drawnFromImage(state));
    uniforms.set("brickwallSize", view_->front().width, view_->front().height);
    uniforms.set("brickwallViewport", viewport->width(), viewport->height());
    uniforms.set("brickwallUp", drawing_.flipped ? -1.0 : 1.0);
    uniforms.set("brickwallMargin", drawing_.margin);
    uniforms.set("brickwallPass", pass_ == DrawerPass::depth ? 0.0 : 1.0);
    osg::Geometry::drawImplementation(info);
}

} // namespace brickwall
