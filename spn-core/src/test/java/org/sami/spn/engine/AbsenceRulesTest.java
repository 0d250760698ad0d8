package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.DurationValue;

/** In edges that ask only for the absence of tokens (R-OCC-7). */
class AbsenceRulesTest {
    /** Robots go out and home; "all home" ends the mission once all who are home have arrived and nobody is out. */
    private static NetBuilder outAndHome(String... absence) {
        return new NetBuilder("net")
                .start("s")
                .output("out", "Do")
                .output("home", "Do")
                .end("e")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "out", "take all relevant")
                .transition("there", "Done")
                .in("out", "there", "relevant all")
                .out("there", "home", "take all relevant")
                .transition("all home", "Done")
                .waitForAll("all home")
                .in("home", "all home", "relevant all")
                .in("out", "all home", absence)
                .out("all home", "e", "take all relevant");
    }

    private static Session sent(NetBuilder net) {
        Session s = new Session(net.build());
        s.join("A", "B").start("net");
        s.news("News", "A");
        s.news("News", "B");
        return s;
    }

    @Test
    void anArrivalCountsForTheTransitionThatTakesTheRobotAndNotForWhoAsksThatItIsAway() {
        for (String absence : new String[] {"proxy = 0", "any = 0", "proxy < 1", "relevant = 0"}) {
            Session s = sent(outAndHome(absence));
            long m = s.idOf("net");

            s.answer("Done", s.activations("out").get(0), "A");
            s.answer("Done", s.activations("out").get(1), "B");
            assertThat(s.marking(m, "home")).as(absence).isEqualTo("A B");
            s.answer("Done", s.activations("home").get(0), "A");
            assertThat(s.outcome(m)).as("B is on its way home").isEmpty();
            s.answer("Done", s.activations("home").get(1), "B");

            assertThat(s.outcome(m)).contains(Outcome.ENDED);
        }
    }

    @Test
    void aSecondAnswerToWhatWasAskedThereDoesNotCountLaterEither() {
        Session s = sent(outAndHome("proxy = 0"));
        long m = s.idOf("net");
        s.answer("Done", s.activations("out").get(0), "A");
        s.answer("Done", s.activations("out").get(1), "B");

        s.answer("Done", s.activations("out").get(0), "A");
        s.answer("Done", s.activations("out").get(1), "B");

        assertThat(s.outcome(m)).isEmpty();
        assertThat(s.notes()).containsExactly(NoteKind.LATE);
    }

    @Test
    void newsOfRobotsWhoseAbsenceIsAskedForIsNotKept() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "out", "take all relevant")
                .transition("there", "Done2")
                .in("out", "there", "relevant all")
                .out("there", "home", "take all relevant")
                .transition("count", "Other")
                .in("home", "count", "relevant all")
                .in("out", "count", "proxy = 0")
                .out("count", "x", "add all relevant")
                .build());
        s.join("A").start("net");
        s.news("News", "A");
        s.news("Other", "A");
        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);

        s.news("Done2", "A");

        assertThat(s.allFired()).doesNotContain("count");
    }

    @Test
    void anEdgeThatAlsoAsksForTokensReceivesTheirAnswers() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .transition("t", "Done")
                .in("s", "t", "task = 0", "proxy >= 1")
                .out("t", "x", "take all proxy")
                .build());
        long m = s.join("A").start("net");

        s.answer("Done", "s", "A");

        assertThat(s.marking(m, "x")).isEqualTo("A");
    }

    @Test
    void anAnswerThatNamesNobodyIsForWhoAsksForOthersOfTheVisit() {
        for (boolean generic : new boolean[] {true, false}) {
            NetBuilder net = new NetBuilder("net")
                    .start("s")
                    .output(
                            "w",
                            "StartTimer",
                            Map.of("duration", new FieldSource.Fixed(new DurationValue(1000))),
                            Map.of())
                    .transition("send", "News")
                    .in("s", "send", "relevant all")
                    .out(
                            "send",
                            "w",
                            generic
                                    ? new String[] {"take all relevant", "take 1 generic"}
                                    : new String[] {"take all relevant"})
                    .transition("gone", "Other")
                    .in("w", "gone", "relevant all")
                    .out("gone", "x", "take all relevant")
                    .transition("empty", "TimerExpired")
                    .in("w", "empty", "proxy = 0")
                    .out("empty", "y", "add 1 generic");
            Session s = new Session(net.build());
            long m = s.join("A").start("net");
            s.news("News", "A");

            s.advance(1000);
            s.news("Other", "A");

            assertThat(s.marking(m, "y")).isEqualTo(generic ? "generic" : "");
        }
    }
}
