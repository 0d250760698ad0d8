package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;

/** Exactly the choices of colours that fulfil a condition become transitions, however many there would be without it. */
class ColourChoicesTest {
    private static final int SEEDS = 300;
    private static final int COLOURS = 3;
    private static final int VARIABLES = 4;

    /** A condition as text and as what it means. */
    private record Condition(String text, Predicate<int[]> meaning) {}

    @Test
    void choicesAreThoseOfEveryOneTried() {
        for (int seed = 0; seed < SEEDS; seed++) {
            Condition condition = condition(new Random(seed), 3);
            List<String> expected = new ArrayList<>();
            for (int number = 0; number < Math.pow(COLOURS, VARIABLES); number++) {
                int[] values = new int[VARIABLES];
                int rest = number;
                for (int i = VARIABLES - 1; i >= 0; i--) {
                    values[i] = rest % COLOURS;
                    rest /= COLOURS;
                }
                if (condition.meaning().test(values)) {
                    expected.add(name(values));
                }
            }

            PetriNet net = read(condition.text(), COLOURS, VARIABLES).net().orElseThrow();

            List<String> found = new ArrayList<>();
            for (int t = 0; t < net.transitionCount(); t++) {
                found.add(net.transitionId(t));
            }
            assertThat(new TreeSet<>(found))
                    .as("seed " + seed + ": " + condition.text())
                    .isEqualTo(new TreeSet<>(expected));
            assertThat(found).as("seed " + seed).hasSameSizeAs(expected);
        }
    }

    private static String name(int[] values) {
        StringBuilder name = new StringBuilder("t(");
        for (int i = 0; i < values.length; i++) {
            name.append(i == 0 ? "v" : ",v").append(i).append('=').append(values[i]);
        }
        return name.append(')').toString();
    }

    private static Condition condition(Random random, int depth) {
        // each variable is named in its order first, by a condition that always holds
        List<Condition> all = new ArrayList<>();
        for (int i = 0; i < VARIABLES; i++) {
            all.add(new Condition(two("equality", variable(i), variable(i)), values -> true));
        }
        int more = 1 + random.nextInt(3);
        for (int i = 0; i < more; i++) {
            all.add(some(random, depth));
        }
        StringBuilder text = new StringBuilder("<and>");
        all.forEach(each -> text.append("<subterm>" + each.text() + "</subterm>"));
        return new Condition(
                text + "</and>",
                values -> all.stream().allMatch(each -> each.meaning().test(values)));
    }

    private static Condition some(Random random, int depth) {
        if (depth == 0 || random.nextInt(3) == 0) {
            int a = random.nextInt(VARIABLES);
            int b = random.nextInt(VARIABLES);
            return switch (random.nextInt(4)) {
                case 0 -> new Condition(two("equality", variable(a), variable(b)), v -> v[a] == v[b]);
                case 1 -> new Condition(two("inequality", variable(a), variable(b)), v -> v[a] != v[b]);
                case 2 -> new Condition(two("lessthan", variable(a), variable(b)), v -> v[a] < v[b]);
                default ->
                    new Condition(two("equality", variable(a), "<useroperator declaration='c1'/>"), v -> v[a] == 1);
            };
        }
        Condition first = some(random, depth - 1);
        Condition second = some(random, depth - 1);
        return switch (random.nextInt(3)) {
            case 0 ->
                new Condition(
                        two("and", first.text(), second.text()), first.meaning().and(second.meaning()));
            case 1 ->
                new Condition(
                        two("or", first.text(), second.text()), first.meaning().or(second.meaning()));
            default ->
                new Condition(
                        "<not><subterm>" + first.text() + "</subterm></not>",
                        first.meaning().negate());
        };
    }

    @Test
    void manyVariablesThatAreBoundToEachOtherAreFewChoices() {
        StringBuilder text = new StringBuilder("<and>");
        for (int i = 0; i < 9; i++) {
            text.append("<subterm>" + two("equality", variable(i), variable(i + 1)) + "</subterm>");
        }

        PetriNet net = read(text + "</and>", 30, 10).net().orElseThrow();

        assertThat(net.transitionCount()).isEqualTo(30);
    }

    @Test
    @Tag("long")
    void moreThanCanBeTriedIsRefused() {
        StringBuilder text = new StringBuilder("<and>");
        for (int i = 0; i < 5; i++) {
            text.append("<subterm>" + two(i < 4 ? "equality" : "lessthan", variable(i), variable(i)) + "</subterm>");
        }

        PnmlReading reading = read(text + "</and>", 30, 5);

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo("E-SIZE");
        assertThat(reading.findings().get(0).message()).contains("too many colours");
    }

    private static String variable(int number) {
        return "<variable refvariable='v" + number + "'/>";
    }

    private static String two(String operator, String first, String second) {
        return "<" + operator + "><subterm>" + first + "</subterm><subterm>" + second + "</subterm></" + operator + ">";
    }

    private static PnmlReading read(String condition, int colours, int variables) {
        StringBuilder text = new StringBuilder("<pnml xmlns='http://www.pnml.org/version-2009/grammar/pnml'><net id='n'"
                + " type='http://www.pnml.org/version-2009/grammar/symmetricnet'><page id='page'>"
                + "<transition id='t'><condition><structure>"
                + condition
                + "</structure></condition></transition></page><declaration><structure><declarations>"
                + "<namedsort id='S' name='S'><finiteenumeration>");
        for (int i = 0; i < colours; i++) {
            text.append("<feconstant id='c" + i + "' name='" + i + "'/>");
        }
        text.append("</finiteenumeration></namedsort>");
        for (int i = 0; i < variables; i++) {
            text.append("<variabledecl id='v" + i + "' name='v" + i + "'><usersort declaration='S'/></variabledecl>");
        }
        text.append("</declarations></structure></declaration></net></pnml>");
        return PnmlReader.read(
                new ByteArrayInputStream(text.toString().getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
    }
}
