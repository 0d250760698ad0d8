package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class OutboxTest {
    private final List<String> sent = new ArrayList<>();
    private final List<Runnable> confirmations = new ArrayList<>();
    private final Outbox outbox = new Outbox((text, confirm) -> {
        sent.add(text);
        confirmations.add(confirm);
    });

    @Test
    void slowReaderGetsNoRowsMeanwhileAndABoundedNumberOfReplies() {
        assertThat(outbox.isIdle()).isTrue();
        assertThat(outbox.offer("rows")).isTrue();
        assertThat(outbox.isIdle()).isFalse();
        for (int i = 0; i < Outbox.MOST_REPLIES; i++) {
            assertThat(outbox.offer("reply " + i)).isTrue();
        }

        assertThat(outbox.offer("one more")).isFalse();
        assertThat(sent).containsExactly("rows");
    }

    @Test
    void readerThatGoesOnGetsAllInOrder() {
        outbox.offer("one");
        outbox.offer("two");
        confirmations.get(0).run();
        confirmations.get(1).run();

        assertThat(sent).containsExactly("one", "two");
        assertThat(outbox.isIdle()).isTrue();
    }
}
