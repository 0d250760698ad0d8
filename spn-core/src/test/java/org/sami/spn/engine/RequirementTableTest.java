package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;

/**
 * Every kind with every match and every action (R-IN-1, R-IN-2, R-OUT-1). The pool is always {@code generic A B #T} in the
 * start place; a second start of the tokens is made by adding copies where a row wants two of a kind.
 */
class RequirementTableTest {
    private static NetBuilder net() {
        return new NetBuilder("net").task("T", "Measure", Map.of()).start("s").places("x");
    }

    @ParameterizedTest
    @CsvSource({
        "generic = 0, false",
        "generic < 1, false",
        "generic < 2, true",
        "generic >= 1, true",
        "generic >= 2, false",
        "generic == 1, true",
        "generic == 2, false",
        "proxy = 0, false",
        "proxy < 2, false",
        "proxy < 3, true",
        "proxy >= 2, true",
        "proxy >= 3, false",
        "proxy == 2, true",
        "proxy == 1, false",
        "proxy == 3, false",
        "task = 0, false",
        "task < 1, false",
        "task < 2, true",
        "task >= 1, true",
        "task >= 2, false",
        "task == 1, true",
        "any = 0, false",
        "any < 4, false",
        "any < 5, true",
        "any >= 4, true",
        "any >= 5, false",
        "any == 4, true",
        "any == 3, false",
        "task:T >= 1, true",
        "task:T = 0, false",
        "task:T < 1, false",
        "task:T == 1, true",
        "task:Measure >= 1, true",
        "task:Measure >= 2, false",
        "task:Look = 0, true",
        "task:Look >= 1, false",
        "task:Other < 1, true",
        "always, true"
    })
    void anInRequirementWithoutOccurrenceIsMetAsItSays(String requirement, boolean fires) {
        Session s = new Session(net().transition("t")
                .in("s", "t", requirement)
                .out("t", "x", "add 1 generic")
                .build());
        s.join("A", "B");

        long m = s.start("net");

        assertThat(s.allFired().contains("t")).isEqualTo(fires);
        assertThat(s.view().whyNotEnabled(m, "t").reasons().isEmpty()).isEqualTo(fires);
    }

    @ParameterizedTest
    @CsvSource({
        "relevant all, A, true", "relevant all, C, false", "relevant >= 1, A, true", "relevant >= 2, A, false",
        "relevant >= 1, C, false", "relevant = 0, C, true", "relevant = 0, A, false", "relevant < 1, C, true",
        "relevant < 1, A, false", "relevant < 2, A, true", "relevant == 1, A, true", "relevant == 1, C, false",
        "relevant == 2, A, false"
    })
    void anInRequirementOnRelevantTokensSpeaksOfThoseNamed(String requirement, String named, boolean fires) {
        Session s = new Session(net().transition("t", "News")
                .in("s", "t", requirement)
                .out("t", "x", "add 1 generic")
                .build());
        s.join("A", "B");
        s.start("net");

        s.news("News", named);

        assertThat(s.fired().contains("t")).isEqualTo(fires);
    }

    @ParameterizedTest
    @CsvSource({
        "take 1 generic,          A B #T,           generic",
        "take all generic,        A B #T,           generic",
        "take 2 generic,          A B #T,           generic",
        "take 1 proxy,            generic B #T,     A",
        "take all proxy,          generic #T,       A B",
        "take 5 proxy,            generic #T,       A B",
        "take 1 task,             generic A B,      #T",
        "take all task,           generic A B,      #T",
        "take 2 any,              B #T,             generic A",
        "take all any,            '',               generic A B #T",
        "take 1 task:T,           generic A B,      #T",
        "take all task:Measure,   generic A B,      #T",
        "take 1 task:Look,        generic A B #T,   ''",
        "take all relevant,       generic A #T,     B",
        "consume 1 generic,       A B #T,           ''",
        "consume all generic,     A B #T,           ''",
        "consume 1 proxy,         generic B #T,     ''",
        "consume all proxy,       generic #T,       ''",
        "consume all task,        generic A B,      ''",
        "consume 2 any,           B #T,             ''",
        "consume all any,         '',               ''",
        "consume 1 task:T,        generic A B,      ''",
        "consume all relevant,    generic A #T,     ''",
        "add 1 generic,           generic A B #T,   generic",
        "add 3 generic,           generic A B #T,   generic generic generic",
        "add all generic,         generic A B #T,   generic",
        "add 1 proxy,             generic A B #T,   A",
        "add all proxy,           generic A B #T,   A B",
        "add all task,            generic A B #T,   #T",
        "add 2 any,               generic A B #T,   generic A",
        "add all any,             generic A B #T,   generic A B #T",
        "add 1 task:T,            generic A B #T,   #T",
        "add all relevant,        generic A B #T,   B",
        "take 0 proxy,            generic A B #T,   ''"
    })
    void anOutRequirementMovesWhatItSays(String requirement, String left, String moved) {
        Session s = new Session(net().transition("t", "News")
                .in("s", "t", "always")
                .out("t", "x", requirement)
                .build());
        s.join("A", "B");
        long m = s.start("net");

        s.news("News", "B");

        assertThat(s.marking(m, "s")).isEqualTo(left);
        assertThat(s.marking(m, "x")).isEqualTo(moved);
    }

    @ParameterizedTest
    @CsvSource({"add all relevant, C", "take all relevant, ''", "consume all relevant, ''"})
    void onlyAddMakesATokenThatIsNotThere(String requirement, String added) {
        Session s = new Session(net().transition("t", "News")
                .in("s", "t", "always")
                .out("t", "x", requirement)
                .build());
        s.join("A", "B");
        long m = s.start("net");

        s.news("News", "C");

        assertThat(s.marking(m, "x")).isEqualTo(added);
    }

    @ParameterizedTest
    @CsvSource({
        "take all, '', C A B",
        "consume all, '', ''",
        "add all, C A B, A B C",
        "take 1, A B, C",
        "take 2, B, C A",
        "take 4, '', C A B",
        "consume 2, B, ''",
        "add 2, C A B, A B"
    })
    void relevantTokensGoInTheOrderOfThePoolAndAreMadeInTheOrderOfTheNames(String action, String left, String moved) {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .places("x", "p", "q")
                .transition("toP", "Other")
                .in("s", "toP", "relevant all")
                .out("toP", "p", "take all relevant")
                .transition("toQ", "News")
                .in("s", "toQ", "relevant all")
                .out("toQ", "q", "take all relevant")
                .transition("t", "Done")
                .in("q", "t", "always")
                .in("p", "t", "always")
                .out("t", "x", action + " relevant")
                .build());
        s.join("A", "B", "C");
        long m = s.start("net");
        s.news("Other", "A");
        s.news("Other", "B");
        s.news("News", "C");

        s.news("Done", "A", "B", "C");

        String before = (s.marking(m, "q") + " " + s.marking(m, "p")).trim();
        assertThat(before).isEqualTo(left);
        assertThat(s.marking(m, "x")).isEqualTo(moved);
    }

    @org.junit.jupiter.api.Test
    void anOccurrenceWithTasksNamesItsTasksOnly() {
        Session s = new Session(net().transition("t", "News")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        s.join("A", "B");
        long m = s.start("net");

        s.step(new org.sami.spn.protocol.Input.Received(new Occurrence(
                "News",
                0,
                0,
                java.util.List.of("A"),
                java.util.List.of(new org.sami.spn.value.TaskId(m, "T")),
                Map.of())));

        assertThat(s.marking(m, "x")).isEqualTo("#T");
        assertThat(s.fired()).containsExactly("t");
    }
}
