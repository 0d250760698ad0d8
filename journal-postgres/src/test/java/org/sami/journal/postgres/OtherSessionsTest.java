package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.sql.Connection;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The sessions beside one in the database of a pair. */
@Timeout(300)
class OtherSessionsTest {
    private static final Duration LENGTH = Duration.ofMillis(3500);
    private static final long STEP_NANOS = 500_000_000;

    private long now;

    @Test
    void namesTheOneThatMayGoOnUntilItIsGivenBackAndAgainWhenAllIsForgotten() throws Exception {
        try (EmbeddedPostgres server = TestServer.builder().start()) {
            String own = TestServer.address(server.getPort());
            String other = TestServer.address(server.getPort());
            Journals.create("laptop-1", own).close();
            try (PostgresJournal goesOn = Journals.create("laptop-1", other);
                    Connection connection = TestServer.connect(own)) {
                assertThat(goesOn.epoch()).isEqualTo(1);
                String name = PostgresAddress.parse(other).schema();
                OtherSessions sessions = new OtherSessions(PostgresAddress.parse(own), LENGTH);
                assertThat(look(sessions, connection, false, 20))
                        .as("cut off, and it does not count on the standby")
                        .isEqualTo("the session " + name + " of this pair may go on at the other base");
                TestServer.run(other, "UPDATE lease SET ends = ends + interval '1 s'");
                assertThat(look(sessions, connection, true, 1))
                        .isEqualTo("the session " + name + " of this pair goes on at the other base");
                assertThat(look(sessions, connection, true, 8)).isEqualTo("all are over");

                sessions.forget();
                assertThat(look(sessions, connection, false, 20)).contains("may go on");
            }
        }
    }

    private String look(OtherSessions sessions, Connection connection, boolean follows, int looks) throws Exception {
        String last = "";
        for (int look = 0; look < looks; look++) {
            now += STEP_NANOS;
            last = sessions.live(connection, follows, now).orElse("all are over");
        }
        return last;
    }
}
