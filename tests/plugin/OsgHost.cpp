// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "OsgHost.h"

#include "brickwall/tests/common/ScratchFolder.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brickwall::test {
namespace {

constexpr double screenHeight = 0.26, screenDistance = 0.5, eyeSeparation = 0.05; // metres; OSG's defaults

const std::vector<std::string> commonEnvironment = {
    fmt::format("OSG_LIBRARY_PATH={}", BRICKWALL_LIBRARY_FOLDER),
    fmt::format("OSG_SCREEN_HEIGHT={}", screenHeight),
    fmt::format("OSG_SCREEN_WIDTH={}", screenHeight * 4.0 / 3.0), // stereo takes this shape and not the window's
    fmt::format("OSG_SCREEN_DISTANCE={}", screenDistance),
    fmt::format("OSG_EYE_SEPARATION={}", eyeSeparation),
    "OSG_SPLIT_STEREO_AUTO_ADJUST_ASPECT_RATIO=OFF",
    "OSG_MULTI_SAMPLES=0",
};

} // namespace

OsgHost::OsgHost(const std::string& command, const std::vector<std::string>& environment)
{
    static int count = 0;
    log_ = scratchFile(fmt::format("host{}.log", ++count));
    pid_ = fork();
    if (pid_ != 0)
        return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setpgid(0, 0);
    for (const auto* list : {&commonEnvironment, &environment}) {
        for (const std::string& setting : *list)
            putenv(const_cast<char*>(setting.c_str()));
    }
    const std::string line = "exec " + command + " >" + log_ + " 2>&1";
    execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    _exit(127);
}

OsgHost::~OsgHost()
{
    if (!running())
        return;
    kill(pid_, SIGKILL);
    wait();
}

bool OsgHost::running()
{
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_)
        pid_ = -1;
    return pid_ > 0;
}

int OsgHost::wait()
{
    if (pid_ > 0)
        waitpid(pid_, &status_, 0);
    pid_ = -1;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

std::string OsgHost::output() const
{
    std::ifstream in(log_);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

osg::ref_ptr<osg::Image> screenPicture(int width, int height, const std::string& display)
{
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(width, height, 1, GL_RGB, GL_UNSIGNED_BYTE);
    Display* connection = XOpenDisplay(display.empty() ? nullptr : display.c_str());
    if (!connection)
        return picture;
    XImage* image = XGetImage(connection, DefaultRootWindow(connection), 0, 0, width, height, AllPlanes, ZPixmap);
    for (int y = 0; image && y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const unsigned long value = XGetPixel(image, x, height - 1 - y);
            unsigned char* p = picture->data(x, y);
            p[0] = (value >> 16) & 255;
            p[1] = (value >> 8) & 255;
            p[2] = value & 255;
        }
    }
    if (image)
        XDestroyImage(image);
    XCloseDisplay(connection);
    return picture;
}

osg::ref_ptr<osg::Image> waitForPicture(int width, int height, OsgHost& host,
                                        const std::function<bool(const osg::Image&)>& isDone,
                                        const std::string& display)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    for (;;) {
        const osg::ref_ptr<osg::Image> picture = screenPicture(width, height, display);
        if (isDone(*picture) || !host.running() || std::chrono::steady_clock::now() > end)
            return picture;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

osg::Matrixd hostModelview(const osg::Vec3d& eye, int side)
{
    return osg::Matrixd::translate(-eye) * osg::Matrixd::translate(-side * 0.5 * eyeSeparation, 0, 0);
}

osg::Matrixd hostProjection(int width, int height, int side)
{
    const double fov = osg::RadiansToDegrees(2.0 * std::atan2(0.5 * screenHeight, screenDistance));
    osg::Matrixd shear;
    shear(2, 0) = -side * eyeSeparation / (2.0 * screenDistance);
    return shear * osg::Matrixd::perspective(fov, double(width) / height, 1.0, 10000.0);
}

std::string cameraPathAt(const osg::Vec3d& eye)
{
    const std::string file = scratchFile("camera.path");
    std::ofstream out(file);
    for (const int time : {0, 1000})
        out << fmt::format("{} {} {} {} 0 0 0 1\n", time, eye.x(), eye.y(), eye.z());
    return "-p " + file;
}

} // namespace brickwall::test
