package org.sami.boat.hull.stream;

import java.io.IOException;

/** Where a device is reached: a USB accessory, a serial port, a TCP address. It may vanish and come back. */
public interface StreamPort {
    /** Its name for people, as {@code /dev/ttyACM0} or {@code 10.0.0.7:5002}. */
    String name();

    /**
     * Opens it; called from one thread at a time, and not before the last connection is closed. It may wait for the device.
     *
     * @throws IOException if it cannot be had; the message says why in words for people
     */
    StreamConnection open() throws IOException;
}
