// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Array>
#include <osg/ref_ptr>

#include <atomic>

namespace brickwall {

/// Far from what others count, and from the counts that mean none.
inline std::atomic<unsigned> nextFreshCount{0x10000000u};

/// An empty array, per vertex, with a modified count that no array from here has had. OpenSceneGraph 3.6, in
/// osg::VertexArrayState::setArray, takes an array for the one that it has sent to OpenGL last if address and modified
/// count are those; a new array at the address of a deleted one has count 0 as that had, and would be drawn with the
/// deleted one's vertices. For vertices that are replaced while their scene is being shown. Any thread.
template <class Array>
osg::ref_ptr<Array> makeFreshArray()
{
    osg::ref_ptr<Array> array = new Array(osg::Array::BIND_PER_VERTEX);
    array->setModifiedCount(nextFreshCount++);
    return array;
}

} // namespace brickwall
