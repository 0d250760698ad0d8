package org.sami.boat.app.boat;

import java.io.IOException;
import java.nio.file.Files;

/**
 * The stop that a person on board has pressed: nothing drives the motors until it is released on board again, over all starts of the app. Safe for use by
 * several threads.
 */
public final class PhoneStop {
    private final AppFiles files;
    private volatile boolean latched;

    /** As it was left. */
    public PhoneStop(AppFiles files) {
        this.files = files;
        latched = Files.exists(files.stopped());
    }

    /** Whether nothing may drive the motors. */
    public boolean isLatched() {
        return latched;
    }

    /**
     * Stops at once.
     *
     * @throws IOException if the stop cannot be kept over a restart; it holds until then
     */
    public void latch() throws IOException {
        latched = true;
        AppFiles.write(files.stopped(), "");
    }

    /**
     * Releases the stop: what the boat server commands drives the motors again.
     *
     * @throws IOException if that cannot be kept; the stop then stays
     */
    public void release() throws IOException {
        Files.deleteIfExists(files.stopped());
        latched = false;
    }
}
