package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

/** A vehicle that needs a while for a command and says how far it is with it. */
@Timeout(300)
class CommandProgressTest {
    private static final int ARM = 400;

    @TempDir
    private Path folder;

    @Test
    void howFarItIsIsToldOnceForEachPercentage() throws Exception {
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
                LinkClient client = new LinkClient(folder, boat.address() + "/5")) {
            boat.faults().ignoresCommand(ARM);
            client.say(new HoldPosition("hold"));
            Await.until("it is ordered to be armed", () -> boat.faults().ignoredOrders() > 0);

            boat.isAt(ARM, 40);
            boat.isAt(ARM, 40);
            boat.isAt(ARM, 80);

            Await.until(
                    "it is told",
                    () -> client.said("mav5 is at it: ", Priority.LOW).size() == 2);
            assertThat(client.said("mav5 is at it: ", Priority.LOW))
                    .isEqualTo(List.of("mav5 is at it: arm, 40 %", "mav5 is at it: arm, 80 %"));
        }
    }
}
