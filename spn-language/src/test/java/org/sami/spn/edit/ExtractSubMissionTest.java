package org.sami.spn.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.ValueType;

class ExtractSubMissionTest {
    private static final Set<String> INSIDE = Set.of("a", "ok", "b", "ok2");

    /** Robots are sent by News, do two things one after another, each at its own pace, and gather. */
    private static NetBuilder net() {
        return new NetBuilder("p")
                .start("s")
                .end("end")
                .variable("@what", ValueType.Simple.TEXT)
                .output("a", "Do", Map.of("text", new FieldSource.FromVariable("@what")), Map.of())
                .output("b", "Do")
                .places("gathered")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "a", "take all relevant")
                .transition("ok", "Done")
                .in("a", "ok", "relevant all")
                .out("ok", "b", "take all relevant")
                .transition("ok2", "Done2")
                .in("b", "ok2", "relevant all")
                .out("ok2", "gathered", "take all relevant")
                .transition("over", "Failed")
                .in("gathered", "over", "relevant all")
                .out("over", "end", "take all relevant");
    }

    private static Project extracted(Plan plan) {
        return new ExtractSubMission("p", INSIDE, "work", "Work")
                .apply(NetBuilder.project(plan), TestVocabulary.TEST)
                .project()
                .orElseThrow();
    }

    private static String refused(Plan plan, String... selection) {
        EditResult result = new ExtractSubMission("p", Set.of(selection), "work", "Work")
                .apply(NetBuilder.project(plan), TestVocabulary.TEST);
        assertThat(result).isInstanceOf(EditResult.Refused.class);
        String message = ((EditResult.Refused) result).message();
        assertThat(ExtractSubMission.whyNot(plan, Set.of(selection), TestVocabulary.TEST))
                .contains(message);
        return message;
    }

    private static Session sent(Project project) {
        Session s = new Session(project.plans().toArray(Plan[]::new));
        s.join("A", "B").start("p");
        s.news("News", "A");
        s.news("News", "B");
        return s;
    }

    @Test
    void robotsGoThroughTheSubMissionOneByOneAsBefore() {
        Session whole = sent(NetBuilder.project(net().build()));
        Session parts = sent(extracted(net().build()));

        for (Session s : List.of(whole, parts)) {
            s.answer("Done", s.activations("a").get(1), "B");
            s.answer("Done2", s.activations("b").get(0), "B");
            assertThat(s.marking(s.idOf("p"), "gathered")).isEqualTo("B");
            s.answer("Done", s.activations("a").get(0), "A");
            s.answer("Done2", s.activations("b").get(1), "A");
            assertThat(s.marking(s.idOf("p"), "gathered")).isEqualTo("B A");
        }
    }

    @Test
    void whatIsExtractedReadsTheVariablesOfItsParentAndBringsNoError() {
        Project project = extracted(net().build());
        Plan child = project.plan("work").orElseThrow();

        assertThat(child.startPlace().orElseThrow().id()).isEqualTo("a");
        assertThat(child.reads()).containsExactly("@what");
        assertThat(child.variables()).isEmpty();
        assertThat(errors(project)).isEqualTo(errors(NetBuilder.project(net().build())));
    }

    private static List<String> errors(Project project) {
        return PlanChecks.check(project, TestVocabulary.TEST).stream()
                .filter(Finding::isError)
                .map(Finding::message)
                .toList();
    }

    @Test
    void thePlaceStandsInTheMiddleOfWhatItReplaces() {
        Plan plan = net().build()
                .withLayout(Map.of(
                        "a", new LayoutPoint(0, 0),
                        "b", new LayoutPoint(100, 40),
                        "gathered", new LayoutPoint(250, 20)));

        Project project = extracted(plan);

        assertThat(project.plan("p").orElseThrow().layout())
                .containsEntry("work", new LayoutPoint(50, 20))
                .containsEntry("work-returned", new LayoutPoint(150, 20))
                .doesNotContainKeys("a", "b");
        assertThat(project.plan("work").orElseThrow().layout())
                .containsEntry("b", new LayoutPoint(100, 40))
                .containsEntry("end", new LayoutPoint(250, 20));
    }

    @Test
    void aSelectionThatKeepsNoBorderIsRefusedWithTheRule() {
        Plan plan = net().build();

        assertThat(refused(plan, "a")).contains("at least one of each");
        assertThat(refused(plan, "s", "send", "a")).contains("start place \"s\" has to stay");
        assertThat(refused(plan, "gathered", "over", "end")).contains("end place \"end\" has to stay");
        assertThat(refused(plan, "ok", "b")).contains("The transition \"ok\" inside takes tokens from \"a\" outside");
        assertThat(refused(plan, "a", "ok", "b"))
                .contains("The transition \"ok2\" outside takes tokens from \"b\" inside");
        assertThat(refused(net().out("send", "b", "take 1 generic").build(), "a", "ok", "b", "ok2"))
                .contains("come into the selection at \"a\" and \"b\"");
        assertThat(refused(net().out("ok", "end", "take 1 generic").build(), "a", "ok", "b", "ok2"))
                .contains("leave the selection to \"end\" and \"gathered\"");
    }
}
