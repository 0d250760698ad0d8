package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.crw.manipulation.ManipulationLimit;
import org.sami.crw.manipulation.ManipulationPolicy;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.protocol.Priority;

/** What the meta-markup of an event may do to the list of messages (thesis 5.3, second scenario). */
class MessageManipulationTest {
    private long nowMs;
    private final MessageList list =
            new MessageList(10, Runnable::run, new OperatorLog(Runnable::run, () -> nowMs), () -> nowMs);

    private void came(String text, ManipulationLimit limit) {
        list.add(message(text).limited("plan event", Set.of(limit)));
        list.publish();
    }

    private OperatorMessage message(String text) {
        return new OperatorMessage(nowMs, 1, OperatorMessage.Source.PLAN, Priority.MEDIUM, text, List.of(), "");
    }

    private void later(long millis) {
        nowMs += millis;
        list.tick(nowMs);
        list.publish();
    }

    private List<String> shown() {
        return list.messages().stream().map(OperatorMessage::text).toList();
    }

    @Test
    void suppressDiscardsWhatComesTooSoon() {
        came("one", ManipulationLimit.SUPPRESS);
        later(1000);
        came("two", ManipulationLimit.SUPPRESS);
        later(ManipulationPolicy.COOLDOWN_MILLIS);
        came("three", ManipulationLimit.SUPPRESS);

        assertThat(shown()).containsExactly("three", "one");
    }

    @Test
    void timedBatchShowsWhatComesTooSoonTogetherLater() {
        came("one", ManipulationLimit.TIMED_BATCH);
        later(1000);
        came("two", ManipulationLimit.TIMED_BATCH);
        came("three", ManipulationLimit.TIMED_BATCH);
        later(ManipulationPolicy.COOLDOWN_MILLIS - 1001);
        assertThat(shown()).containsExactly("one");

        later(1);
        assertThat(shown()).containsExactly("three", "two", "one");
    }

    @Test
    void focusSuppressLeavesTheListAloneWhileTheOperatorWorksThere() {
        list.focus(true);
        came("one", ManipulationLimit.FOCUS_SUPPRESS);
        list.focus(false);
        came("two", ManipulationLimit.FOCUS_SUPPRESS);

        assertThat(shown()).containsExactly("two");
    }

    @Test
    void timedSuppressLeavesTheListAloneForAWhileAfterItsUse() {
        came("one", ManipulationLimit.TIMED_SUPPRESS);
        list.acknowledge(1);
        came("two", ManipulationLimit.TIMED_SUPPRESS);
        later(ManipulationPolicy.IN_USE_MILLIS);
        came("three", ManipulationLimit.TIMED_SUPPRESS);

        assertThat(shown()).containsExactly("three", "one");
    }

    @Test
    void messagesOfOtherEventsAreShownMeanwhile() {
        came("one", ManipulationLimit.SUPPRESS);
        list.add(message("free"));
        list.add(message("other").limited("plan another", Set.of(ManipulationLimit.SUPPRESS)));
        list.publish();

        assertThat(shown()).containsExactly("other", "free", "one");
    }
}
