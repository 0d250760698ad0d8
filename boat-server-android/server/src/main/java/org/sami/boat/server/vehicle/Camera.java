package org.sami.boat.server.vehicle;

/** A camera that looks ahead; given with the vehicle by whoever builds the server. */
public interface Camera {

    /**
     * Begins to take a picture. Called on the thread that ticks the server: what takes time (exposure, drawing, disk) is done on a thread of the camera.
     */
    CameraShot take();
}
