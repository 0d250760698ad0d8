package org.sami.boat.app.screen;

import java.io.IOException;
import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;
import org.sami.boat.app.boat.LoopbackBoard;
import org.sami.boat.app.phone.UsbBoardPort;
import org.sami.boat.hull.stream.StreamConnection;

/** Plugs the board of a test into the phone's USB, in place of an accessory. */
@Implements(UsbBoardPort.class)
public class BoardInUsb {
    private static volatile LoopbackBoard board;

    static void plugIn(LoopbackBoard next) {
        board = next;
    }

    /** Opens the board of the test. */
    @Implementation
    protected StreamConnection open() throws IOException {
        return board.port().open();
    }
}
