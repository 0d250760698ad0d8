package org.sami.lessons.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ValueType;

/** Ids, positions, order and names of variables make no difference; all else does. */
class SamePlanTest {
    private static final InRequirement FREE = InRequirement.unconditional();

    private static Optional<String> difference(Plan a, Plan b) {
        return SamePlan.difference(project(a), project(b));
    }

    private static Project project(Plan... plans) {
        List<Plan> unnamed = Stream.of(plans).map(SamePlanTest::unnamed).toList();
        return new Project("x", "", "crw", List.of(), List.of(), unnamed);
    }

    /** The builder names vertices after their ids: here only those have a name that are given one. */
    private static Plan unnamed(Plan plan) {
        return plan.withPlaces(plan.places().stream()
                        .map(p -> p.name().equals(p.id()) ? p.withName("") : p)
                        .toList())
                .withTransitions(plan.transitions().stream()
                        .map(t -> t.name().equals(t.id()) ? t.withName("") : t)
                        .toList());
    }

    private static VariableSpec integer(String name, int initial) {
        return new VariableSpec(name, ValueType.Simple.INTEGER, Optional.of(new IntegerValue(initial)));
    }

    /** Writes a variable in one place and reads another in the next. */
    private static Plan reading(String id, String first, String second, String read) {
        return new PlanBuilder(id)
                .start(id + "1")
                .places(id + "2")
                .output(id + "1", "Ask", Map.of(), Map.of("a", first, "b", second))
                .output(id + "2", "Use", Map.of("n", new FieldSource.FromVariable(read)), Map.of())
                .transition(id + "t", "Answered")
                .in(id + "1", id + "t", FREE)
                .out(id + "t", id + "2")
                .variable(integer(first, 1))
                .variable(integer(second, 1))
                .build();
    }

    @Test
    void idsPositionsAndOrderMakeNoDifference() {
        Plan a = new PlanBuilder("p")
                .start("a")
                .places("b")
                .end("c")
                .name("b", "Go")
                .transition("t", "Arrived")
                .transition("u", "Failed")
                .in("a", "t", FREE)
                .in("a", "u", FREE)
                .out("t", "b")
                .out("u", "c")
                .at("a", 1, 2)
                .build();
        Plan b = new PlanBuilder("q")
                .end("x")
                .places("y")
                .start("z")
                .name("y", "Go")
                .transition("v", "Failed")
                .transition("w", "Arrived")
                .out("v", "x")
                .out("w", "y")
                .in("z", "v", FREE)
                .in("z", "w", FREE)
                .at("z", 70, 80)
                .build();

        assertThat(difference(a, b)).isEmpty();
    }

    @Test
    void namesOfVariablesMakeNoDifferenceButWhichIsReadDoes() {
        assertThat(difference(reading("p", "@x", "@y", "@x"), reading("q", "@m", "@n", "@m")))
                .isEmpty();
        assertThat(difference(reading("p", "@x", "@y", "@x"), reading("q", "@m", "@n", "@n")))
                .hasValueSatisfying(text -> assertThat(text).contains("variables otherwise"));
    }

    @Test
    void aVariableOfAnotherFirstValueDiffers() {
        Plan a = new PlanBuilder("p").start("a").variable(integer("@x", 1)).build();
        Plan b = new PlanBuilder("p").start("a").variable(integer("@x", 2)).build();

        assertThat(difference(a, b)).hasValueSatisfying(text -> assertThat(text).contains("only there a variable"));
    }

    @Test
    void aNameAnEventAMarkAndARequirementDiffer() {
        Plan plan = new PlanBuilder("p")
                .start("a")
                .transition("t")
                .in("a", "t", FREE)
                .build();

        assertThat(difference(
                        plan,
                        new PlanBuilder("p")
                                .start("a")
                                .name("a", "Go")
                                .transition("t")
                                .in("a", "t", FREE)
                                .build()))
                .hasValueSatisfying(text -> assertThat(text).contains("only there place \"Go\" start"));
        assertThat(difference(
                        plan,
                        new PlanBuilder("p")
                                .start("a")
                                .output("a", "Ask")
                                .transition("t")
                                .in("a", "t", FREE)
                                .build()))
                .hasValueSatisfying(text -> assertThat(text).contains("Ask"));
        assertThat(difference(
                        plan,
                        new PlanBuilder("p")
                                .places("a")
                                .transition("t")
                                .in("a", "t", FREE)
                                .build()))
                .isPresent();
        assertThat(difference(
                        plan,
                        new PlanBuilder("p")
                                .start("a")
                                .transition("t")
                                .in("a", "t", InRequirement.allRelevant())
                                .build()))
                .hasValueSatisfying(text -> assertThat(text).contains("edge").contains("RELEVANT"));
    }

    @Test
    void theSameElementsJoinedOtherwiseDiffer() {
        PlanBuilder ring = new PlanBuilder("p").places("a", "b", "c", "d");
        PlanBuilder pairs = new PlanBuilder("p").places("a", "b", "c", "d");
        for (String way : List.of("ab", "bc", "cd", "da")) {
            step(ring, way);
        }
        for (String way : List.of("ab", "ba", "cd", "dc")) {
            step(pairs, way);
        }

        assertThat(difference(ring.build(), pairs.build()))
                .hasValueSatisfying(text -> assertThat(text).contains("joined otherwise"));
        assertThat(difference(ring.build(), ring.build())).isEmpty();
    }

    private static void step(PlanBuilder plan, String way) {
        plan.transition(way).in(way.substring(0, 1), way, FREE).out(way, way.substring(1));
    }

    @Test
    void manyElementsThatAreAlikeAreComparedInShortTime() {
        PlanBuilder many = new PlanBuilder("p").start("a").end("z");
        for (int i = 0; i < 40; i++) {
            many.transition("t" + i).in("a", "t" + i, FREE).out("t" + i, "z");
        }

        assertThat(difference(many.build(), many.build())).isEmpty();
    }

    @Test
    void plansOfOtherIdsAreComparedInTheirOrder() {
        Plan child = new PlanBuilder("child").start("c").build();
        Plan parent = new PlanBuilder("p").start("a").sub("a", "child").build();
        Plan renamedChild = child.withId("kid");
        Plan renamedParent = new PlanBuilder("q").start("a").sub("a", "kid").build();

        assertThat(SamePlan.difference(project(parent, child), project(renamedParent, renamedChild)))
                .isEmpty();
        assertThat(SamePlan.difference(project(parent, child), project(parent))).contains("It has 2 plans and not 1");
    }
}
