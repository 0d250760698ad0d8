package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Who tries many wrong keys. */
class LoginLimitTest {
    private static final int MANY = 100; // an address gets a new try each 12 s: a slow machine takes more than five

    @TempDir
    private Path folder;

    @Test
    void whoTriesManyWrongKeysIsToldToWait() throws Exception {
        try (ServedSession served = ServedSession.ofPlan("station-keep", folder).with("ben", PersonRole.OBSERVER)) {
            SessionServer server = served.serve();
            served.begin();
            List<String> refusals = new ArrayList<>();
            while (refusals.size() < MANY && refusals.stream().allMatch("no such name and key"::equals)) {
                refusals.add(refusal(server));
            }

            assertThat(refusals).hasSizeGreaterThan(5);
            assertThat(refusals.get(refusals.size() - 1)).startsWith("too many wrong names or keys from ");
        }
    }

    private static String refusal(SessionServer server) throws Exception {
        TestFront front = new TestFront(server);
        front.send("{\"t\":\"hello\",\"v\":1,\"name\":\"ben\",\"key\":\"wrong\"}");
        return front.until(message -> message.path("t").asText().equals("refused"))
                .path("text")
                .asText();
    }
}
