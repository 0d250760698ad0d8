package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.OperatorModels;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/** Which messages a run tells again that it told within the last minute. */
class RepeatedNewsTest {
    private final AtomicLong nowMillis = new AtomicLong();
    private final OperatorModels models = new OperatorModels(Runnable::run, nowMillis::get);
    private final List<String> told = new ArrayList<>();

    private void message(String text, String keyword) {
        nowMillis.addAndGet(2_000);
        models.tell(new OperatorMessage(
                nowMillis.get(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                Priority.MEDIUM,
                text,
                List.of("anna"),
                keyword));
    }

    private List<String> toldOf(Runnable news) {
        try (RunNews run = new RunNews(models, nowMillis::get, new RunObserver.News(told::add, false))) {
            news.run();
        }
        return told.stream().map(line -> line.replaceFirst(".*message: ", "")).toList();
    }

    @Test
    void lossesAndReturnsOfALinkWithinAMinuteAreAllTold() {
        List<String> lines = toldOf(() -> {
            for (int i = 0; i < 3; i++) {
                message("The link to anna is lost", "link/anna");
                message("The link to anna is back", "link/anna");
            }
            message("The link to anna is lost", "link/anna");
        });

        assertThat(lines).hasSize(7).last().isEqualTo("The link to anna is lost");
    }

    @Test
    void whatIsSoStillIsToldOnceAMinute() {
        List<String> lines = toldOf(() -> {
            message("anna is late", "late/anna");
            message("anna is late", "late/anna");
            message("All is done", "");
            message("anna is late", "late/anna");
            message("All is done", "");
        });

        assertThat(lines).containsExactly("anna is late", "All is done");
    }
}
