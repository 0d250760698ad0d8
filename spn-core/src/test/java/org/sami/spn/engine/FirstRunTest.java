package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;

/** A plan from its start to its end. */
class FirstRunTest {
    private static final Plan VISIT = new NetBuilder("visit")
            .start("choose")
            .places("work", "done")
            .end("end")
            .output("choose", "Choose")
            .output("work", "Do")
            .transition("chosen", "Chosen")
            .in("choose", "chosen", "relevant all", "generic >= 1")
            .out("chosen", "work", "take all relevant", "take 1 generic")
            .transition("arrived", "Done")
            .in("work", "arrived", "relevant all")
            .out("arrived", "done", "take all relevant")
            .transition("finish")
            .in("work", "finish", "proxy = 0")
            .in("done", "finish", "proxy >= 1")
            .out("finish", "end", "take all any")
            .build();

    @Test
    void runsFromStartToEnd() {
        Session s = new Session(VISIT).join("A", "B", "C");
        long m = s.start("visit");
        assertThat(s.marking(m, "choose")).isEqualTo("generic A B C");

        s.decide(new Answer.Proxies(List.of("A", "C")));
        assertThat(s.marking(m, "choose")).isEqualTo("B");
        assertThat(s.marking(m, "work")).isEqualTo("A C generic");
        assertThat(s.latest("work").proxies()).containsExactly("A", "C");

        s.answer("Done", "work", "C");
        assertThat(s.marking(m, "done")).isEqualTo("C");
        assertThat(s.fired()).containsExactly("arrived");

        s.answer("Done", "work", "A");
        assertThat(s.fired()).containsExactly("arrived", "finish");
        assertThat(s.outcome(m)).contains(Outcome.ENDED);
        assertThat(s.view().missions()).isEmpty();
    }
}
