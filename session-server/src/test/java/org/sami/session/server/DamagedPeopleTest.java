package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** A list of people that is damaged under a session that goes on, over a real socket on loopback. */
class DamagedPeopleTest {
    @TempDir
    private Path folder;

    @Test
    void sessionSaysThatItCannotReadTheListForAsLongAsItCannot() throws Exception {
        try (ServedSession served = ServedSession.ofPlan("station-keep", folder).with("anna", PersonRole.OPERATOR)) {
            SessionServer server = served.serve();
            served.begin();
            TestFront anna = TestFront.loggedIn(server, "anna", "key of anna");
            Path list = served.people().file();
            String whole = Files.readString(list);

            Files.writeString(list, "{ damaged");

            Await.until("it is said", () -> !faults(served).isEmpty());
            assertThat(faults(served).get(0).fault().whole())
                    .startsWith("The list of people cannot be read: who is connected stays, nobody else gets in")
                    .contains(list.toString());
            anna.send("{\"t\":\"ping\",\"id\":1}");
            assertThat(anna.reply(1).path("t").asText()).isEqualTo("done");

            Files.writeString(list, whole);

            Await.until("it is over", () -> faults(served).isEmpty());
        }
    }

    private static List<HealthEntry> faults(ServedSession served) {
        return served.session().models().health().snapshot().of(HealthKind.FILE);
    }
}
