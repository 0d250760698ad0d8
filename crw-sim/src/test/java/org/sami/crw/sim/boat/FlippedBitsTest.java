package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.testing.Await;
import org.sami.crw.sim.boat.TcpTestFleet.Base;

/** A link that bends a fifth of its frames, either way: what the boat executes is what the base has sent. */
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class FlippedBitsTest {
    @TempDir
    private Path logs;

    /** How boats and bases are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @Test
    void noBentFrameMakesTheBoatDoAnythingElseThanItWasSent() throws Exception {
        try (TcpTestFleet fleet = new TcpTestFleet(logs, links())) {
            BoatOnTcp boat = fleet.boat("anna");
            TestRelay relay = fleet.relay(boat);
            Base base = fleet.impatientBase("base", 50);
            relay.setBent(0.2);
            base.tcp.connect(relay.address());
            base.linked("anna");
            for (int i = 1; i <= 12; i++) {
                String id = "p" + i;
                base.submit("anna", TcpTestFleet.path(id, 1, 1000 + i, 2000 + i, 3000 + i, 4000 + i));
                Await.until(id + " is started", () -> fleet.executedOf("anna", "start") > 0 && starts(fleet, id));
            }

            Set<String> sent =
                    relay.carried().stream().map(FlippedBitsTest::body).collect(Collectors.toSet());
            List<String> executed = new ArrayList<>();
            for (LoggedCommand entry : fleet.log("anna")) {
                executed.add(body(entry.command()));
            }
            assertThat(executed).hasSizeGreaterThanOrEqualTo(24).isSubsetOf(sent);
            assertThat(relay.bent()).as("bent frames").isGreaterThan(20);
            assertThat(base.failures).isEmpty();
        }
    }

    private static boolean starts(TcpTestFleet fleet, String id) {
        try {
            return fleet.executedIds("anna").stream()
                    .anyMatch(done -> done.startsWith(id + "#") && done.contains("/start"));
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static String body(CommandMessage command) {
        return new String(LinkCodec.body(command), java.nio.charset.StandardCharsets.UTF_8);
    }
}
