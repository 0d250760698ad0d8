package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Who drives a real boat by hand over a real socket on loopback, and may no longer. */
class LostRightTest {
    private static final String CLAIM = "{\"t\":\"claim\",\"id\":%d,\"boat\":\"bella\"}";

    @TempDir
    private Path folder;

    private ServedSession served;
    private SessionServer server;
    private MeasuringBoat boat;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder)
                .with("anna", PersonRole.PILOT)
                .with("paul", PersonRole.PILOT);
        server = served.serve();
        served.begin();
        boat = new MeasuringBoat();
        boat.join(served.session());
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
        served.close();
    }

    private static String claim(TestFront front, int id) throws Exception {
        front.send(CLAIM.formatted(id));
        return front.reply(id).path("t").asText();
    }

    @Test
    void boatOfAPersonWhoMayDriveNoLongerIsFreeForOthers() throws Exception {
        TestFront anna = TestFront.loggedIn(server, "anna", "key of anna");
        TestFront paul = TestFront.loggedIn(server, "paul", "key of paul");
        assertThat(claim(anna, 1)).isEqualTo("done");
        assertThat(claim(paul, 1)).isEqualTo("refused");

        served.people().change("anna", PersonRole.OBSERVER, List.of());
        anna.send("{\"t\":\"ping\",\"id\":2}");
        assertThat(anna.reply(2).path("t").asText()).isEqualTo("done");

        assertThat(claim(paul, 2)).isEqualTo("done");
        assertThat(claim(anna, 3)).isEqualTo("refused");
    }
}
