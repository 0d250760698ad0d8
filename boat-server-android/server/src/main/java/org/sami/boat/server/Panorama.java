package org.sami.boat.server;

import org.sami.boat.link.TakePanorama;
import org.sami.boat.server.vehicle.PlaneMath;

/** A turn all round with pictures at equal turns, the first at once. */
final class Panorama {
    private final TakePanorama command;
    private double turnedRad;
    private double lastHeadingRad = Double.NaN;
    private int taken;

    Panorama(TakePanorama command) {
        this.command = command;
    }

    TakePanorama command() {
        return command;
    }

    /** The vehicle heads so now: whether a picture is due, which counts as taken. A heading that is not known is passed over. */
    boolean look(double headingRad) {
        if (Double.isNaN(headingRad)) {
            return false;
        }
        if (!Double.isNaN(lastHeadingRad)) {
            turnedRad += PlaneMath.sameTurn(headingRad - lastHeadingRad);
        }
        lastHeadingRad = headingRad;
        boolean due = !isDone() && turnedRad >= taken * 2 * Math.PI / command.pictures();
        if (due) {
            taken++;
        }
        return due;
    }

    boolean isDone() {
        return taken >= command.pictures();
    }
}
