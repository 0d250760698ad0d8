package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** Who tries many wrong keys. */
class LoginLimitTest {
    private static final int AT_ONCE = 5;

    @TempDir
    private Path folder;

    @Test
    void afterFiveWrongKeysNoKeyOfTheAddressIsLookedUp() throws Exception {
        try (ServedSession served = ServedSession.ofPlan("station-keep", folder).with("ben", PersonRole.OBSERVER)) {
            SessionServer server = served.serve();
            served.begin();
            for (int i = 0; i < AT_ONCE; i++) {
                assertThat(refusal(server, "wrong")).isEqualTo("no such name and key");
            }

            assertThat(refusal(server, "key of ben")).startsWith("too many wrong names or keys from ");
        }
    }

    private static String refusal(SessionServer server, String key) throws Exception {
        TestFront front = new TestFront(server);
        front.send("{\"t\":\"hello\",\"v\":1,\"name\":\"ben\",\"key\":\"" + key + "\"}");
        return front.until(message -> message.path("t").asText().equals("refused"))
                .path("text")
                .asText();
    }
}
