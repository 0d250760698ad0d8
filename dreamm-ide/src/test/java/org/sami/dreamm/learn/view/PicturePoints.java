package org.sami.dreamm.learn.view;

import java.awt.Component;
import java.awt.Point;

/** Where the elements of a step's picture lie, for robots that click them. */
public final class PicturePoints {
    private PicturePoints() {}

    /** The middle of an element, in the picture's pixels; on the event thread. */
    public static Point of(Component picture, String element) {
        return ((PictureView) picture).pixelOf(element);
    }
}
