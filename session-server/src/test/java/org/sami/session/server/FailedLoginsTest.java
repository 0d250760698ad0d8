package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class FailedLoginsTest {
    private static final String HERE = "127.0.0.1";

    private long nanos;
    private final FailedLogins logins = new FailedLogins(() -> nanos);

    private void fail(int times) {
        for (int i = 0; i < times; i++) {
            assertThat(logins.refusal(HERE)).isEmpty();
            logins.note(HERE);
        }
    }

    @Test
    void afterFiveWrongKeysAnAddressTriesNoneAndOthersDo() {
        fail(5);

        assertThat(logins.refusal(HERE)).contains("too many wrong names or keys from " + HERE + "; wait a minute");
        assertThat(logins.refusal("10.0.0.7")).isEmpty();
    }

    @Test
    void aMinuteLaterFiveMayBeTriedAgain() {
        fail(5);
        nanos += TimeUnit.MINUTES.toNanos(1);

        fail(5);
        assertThat(logins.refusal(HERE)).isPresent();
    }
}
