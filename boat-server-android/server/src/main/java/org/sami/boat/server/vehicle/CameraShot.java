package org.sami.boat.server.vehicle;

import java.util.Objects;

/** One picture that a camera was asked to take: it is kept or has failed later, on a thread of the camera. Safe for use by several threads. */
public final class CameraShot {
    private enum State {
        PENDING,
        KEPT,
        FAILED
    }

    private final String fileName;
    private volatile State state;

    private CameraShot(String fileName, State state) {
        this.fileName = Objects.requireNonNull(fileName, "fileName");
        this.state = state;
    }

    /** A picture that will be kept under a name. */
    public static CameraShot begun(String fileName) {
        return new CameraShot(fileName, State.PENDING);
    }

    /** A picture that was taken and is no file, such as one that is only counted. */
    public static CameraShot withoutFile() {
        return new CameraShot("", State.KEPT);
    }

    /** Its file, without a folder; empty if it is none. */
    public String fileName() {
        return fileName;
    }

    /** The picture is whole on board. */
    public void setKept() {
        state = State.KEPT;
    }

    /** There will be no picture. */
    public void setFailed() {
        state = State.FAILED;
    }

    /** Whether it is kept or has failed. */
    public boolean isOver() {
        return state != State.PENDING;
    }

    /** Whether it is whole on board. */
    public boolean isKept() {
        return state == State.KEPT;
    }
}
