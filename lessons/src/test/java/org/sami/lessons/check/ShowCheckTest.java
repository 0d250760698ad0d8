package org.sami.lessons.check;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.LessonMode;
import org.sami.lessons.course.Step;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** A script that cannot be played, or that ends otherwise than its result, is found with its place in the lesson. */
class ShowCheckTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static Project project(Plan plan) {
        return new Project("x", "", "crw", List.of(), List.of(), List.of(plan));
    }

    private static List<Finding> check(String script) {
        Plan start = new PlanBuilder("p").start("a").transition("t").build();
        Plan result =
                new PlanBuilder("p").start("a").transition("t").name("t", "Go").build();
        List<JsonNode> elements = new ArrayList<>();
        try {
            new JsonMapper().readTree(script.replace('\'', '"')).forEach(elements::add);
        } catch (JsonProcessingException e) {
            throw new AssertionError(e);
        }
        Step.Show show =
                new Step.Show("show", "Show", List.of(), Optional.empty(), "start", elements, Optional.of("result"));
        Lesson lesson = new Lesson(
                1,
                "l",
                2,
                "L",
                "",
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                new LessonMode(List.of(), List.of(), List.of()),
                List.of(show));
        Course course = new Course(
                List.of(lesson), List.of(), Map.of("l/start", project(start), "l/result", project(result)), Map.of());
        return ShowCheck.check(course, lesson, show, "/steps/0", DOMAIN);
    }

    @Test
    void aScriptThatGivesItsResultIsRight() {
        assertThat(check("[{'do': 'rename', 'what': 't', 'name': 'Go'}]")).isEmpty();
    }

    @Test
    void anElementThatCannotBeDoneIsNamed() {
        assertThat(check("[{'do': 'rename', 'what': 'x', 'name': 'Go'}]"))
                .singleElement()
                .matches(f -> f.pointer().equals("/steps/0/script/0/what"))
                .matches(f -> f.message().contains("Element 1 of the script (rename x)"));
    }

    @Test
    void anotherResultIsNamedWithWhatDiffers() {
        assertThat(check("[{'do': 'rename', 'what': 't', 'name': 'Gone'}]"))
                .singleElement()
                .matches(f -> f.pointer().equals("/steps/0/result"))
                .matches(f -> f.message().contains("only there transition \"Go\""));
    }

    @Test
    void anUnknownWordIsFoundWhereItStands() {
        assertThat(check("[{'do': 'renam', 'what': 't', 'name': 'Go'}]"))
                .singleElement()
                .matches(f -> f.pointer().equals("/steps/0/script/0/do"));
    }

    @Test
    void anEventThatNoLessonHasIntroducedIsMissingInThePalette() {
        assertThat(
                        check(
                                "[{'do': 'add', 'item': 'palette-event-timer-expired', 'on': 't', 'id': 'e', 'sequence': 'alone'}]"))
                .singleElement()
                .matches(f -> f.pointer().equals("/steps/0/script/0/item"))
                .matches(f -> f.message().contains("The palette has no item \"palette-event-timer-expired\""));
    }
}
