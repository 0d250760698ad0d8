package org.sami.spn.component;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/** Algorithms 4 to 6 of thesis 5.2.4 on small libraries. */
class ComponentChoiceTest {
    private static final Map<String, NamedType> TYPES = Map.of(
            "Colour", new NamedType.Enumeration("Colour", List.of("RED", "GREEN")),
            "Mark", new NamedType.RecordType("Mark", Map.of("at", type("point"))),
            "Flag", new NamedType.RecordType("Flag", Map.of("mark", type("Mark"))),
            "Fleet", new NamedType.RecordType("Fleet", Map.of("flags", type("list<Flag>"))),
            "Chain", new NamedType.RecordType("Chain", Map.of("next", type("list<Chain>"))));

    private static final WidgetType BOATS = widget("Boats", "proxy", "Show.boats");
    private static final WidgetType PATHS = widget("Paths", "path", "Show.paths", "Show.boats");
    private static final WidgetType LOUD = widget("Loud", "", "Loud");
    private static final ComponentType MAP = component("Map", "point", List.of(BOATS, PATHS, LOUD), "Area");
    private static final ComponentType TABLE = component("Table", "point list<point>", List.of(), "Sort.by=NAME");
    private static final ComponentType CONSTANTS = component("Constants", "Enumeration", List.of());
    private static final ComponentLibrary LIBRARY =
            new ComponentLibrary(List.of(MAP, TABLE, CONSTANTS), List.of(BOATS, PATHS, LOUD));
    private static final ComponentChoice CHOICE = new ComponentChoice(LIBRARY, TYPES);

    private static ValueType type(String text) {
        return TypeNames.parse(text).orElseThrow();
    }

    private static WidgetType widget(String name, String selects, String... markups) {
        return new WidgetType(name, name, can(selects, markups));
    }

    private static ComponentType component(String name, String selects, List<WidgetType> widgets, String... markups) {
        return new ComponentType(name, name, can(selects, markups), widgets);
    }

    private static Capabilities can(String selects, String... markups) {
        List<TypePattern> patterns = selects.isEmpty()
                ? List.of()
                : List.of(selects.split(" ")).stream()
                        .map(text -> TypePattern.parse(text).orElseThrow())
                        .toList();
        return new Capabilities(List.of(), patterns, options(markups));
    }

    private static List<MarkupOption> options(String... texts) {
        return List.of(texts).stream()
                .map(text -> MarkupOption.parse(text).orElseThrow())
                .toList();
    }

    private static ChosenComponent select(String type, String... markups) {
        return CHOICE.choose(Purpose.SELECT, type(type), options(markups));
    }

    private static ChosenComponent.Direct direct(ChosenComponent chosen) {
        assertThat(chosen).isInstanceOf(ChosenComponent.Direct.class);
        return (ChosenComponent.Direct) chosen;
    }

    @Test
    void ofEqualComponentsTheFirstOfTheDomainIsTaken() {
        assertThat(direct(select("point")).component()).isEqualTo(MAP);
        assertThat(select("point").score()).isZero();
    }

    @Test
    void moreMarkupWins() {
        assertThat(direct(select("point", "Sort.by=NAME")).component()).isEqualTo(TABLE);
        assertThat(direct(select("point", "Sort.by=AGE")).component()).isEqualTo(MAP);
    }

    @Test
    void onlyWidgetsThatAreNeededAreUsed() {
        assertThat(direct(select("point", "Area")).widgets()).isEmpty();
        assertThat(direct(select("point", "Loud")).widgets()).containsExactly(LOUD);
        assertThat(direct(select("point", "Show.boats")).widgets()).containsExactly(BOATS);
        assertThat(direct(select("point", "Show.boats", "Show.paths")).widgets())
                .as("one widget does both")
                .containsExactly(PATHS);
    }

    @Test
    void choiceOfMarkupOnWhichTwoWidgetsActCountsOnce() {
        assertThat(select("point", "Show.boats").score()).isOne();
    }

    @Test
    void typeThatOnlyWidgetsHandleTakesTheWidgetAlong() {
        assertThat(direct(select("proxy")).widgets()).containsExactly(BOATS);
        assertThat(direct(select("path", "Loud")).widgets()).containsExactly(PATHS, LOUD);
    }

    @Test
    void listWithoutComponentIsOneComponentAnElement() {
        assertThat(direct(select("list<point>")).component()).isEqualTo(TABLE);
        assertThat(select("list<proxy>", "Loud")).isEqualTo(new ChosenComponent.Repeated(select("proxy", "Loud")));
        assertThat(select("list<proxy>", "Loud").score()).isOne();
    }

    @Test
    void mapWithoutComponentIsOneForTheKeyAndOneForTheValueAndTheWorseCounts() {
        ChosenComponent chosen = select("map<proxy,Colour>", "Loud");

        assertThat(chosen).isEqualTo(new ChosenComponent.Entries(select("proxy", "Loud"), select("Colour", "Loud")));
        assertThat(chosen.score()).isZero();
    }

    @Test
    void everyEnumerationIsMeantByOneName() {
        assertThat(direct(select("Colour")).component()).isEqualTo(CONSTANTS);
        assertThat(select("Mark")).as("no enumeration").isInstanceOf(ChosenComponent.Form.class);
    }

    @Test
    void recordIsOpenedIntoItsFieldsAndTheseIntoTheirs() {
        ChosenComponent mark = new ChosenComponent.Form(Map.of("at", select("point")));
        ChosenComponent flag = new ChosenComponent.Form(Map.of("mark", mark));

        assertThat(select("Flag")).isEqualTo(flag);
        assertThat(select("Fleet"))
                .isEqualTo(new ChosenComponent.Form(Map.of("flags", new ChosenComponent.Repeated(flag))));
    }

    @Test
    void recordsDeeperThanTheLimitAreAWarning() {
        assertThat(new ComponentChoice(LIBRARY, TYPES, 2).choose(Purpose.SELECT, type("Fleet"), List.of()))
                .isEqualTo(new ChosenComponent.Warning(
                        "No component is found for Mark: it lies in more than 2 records, one in the other"));
        assertThat(select("Chain").score()).as("a record in itself").isEqualTo(ChosenComponent.NONE);
    }

    @Test
    void typeWithoutComponentIsAWarningThatNamesIt() {
        assertThat(select("map<proxy,list<real>>"))
                .isEqualTo(new ChosenComponent.Warning("No component can show a value of type real"));
        assertThat(CHOICE.choose(Purpose.CREATE, type("point"), List.of()))
                .isEqualTo(new ChosenComponent.Warning("No component can ask for a value of type point"));
    }

    @Test
    void severalValuesAreAFormOrOneWarning() {
        Map<String, ValueType> values = Map.of("where", type("point"));

        assertThat(CHOICE.choose(new Interaction(Purpose.SELECT, values, List.of())))
                .isEqualTo(select("point"));
        assertThat(CHOICE.choose(new Interaction(
                        Purpose.SELECT, Map.of("where", type("point"), "who", type("proxy")), options("Loud"))))
                .isEqualTo(new ChosenComponent.Form(
                        Map.of("where", select("point", "Loud"), "who", select("proxy", "Loud"))));
        assertThat(CHOICE.choose(new Interaction(
                                Purpose.SELECT, Map.of("where", type("point"), "size", type("real")), List.of()))
                        .score())
                .isEqualTo(ChosenComponent.NONE);
    }

    @Test
    void whatIsNoMarkupOptionIsRefused() {
        assertThat(MarkupOption.parse("Sort.method=")).isEmpty();
        assertThat(MarkupOption.parse("")).isEmpty();
        assertThat(MarkupOption.parse("Sort.method=UP")).contains(new MarkupOption("Sort", "method", "UP"));
        assertThatThrownBy(() -> new MarkupOption("Sort", "", "UP")).hasMessageContaining("Sort");
    }

    /** Random libraries against Algorithm 5 as its text says it, without a look at widgets' sets. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void scoreIsThatOfTheThesisForAnyLibrary(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 200; i++) {
            List<ComponentType> components = IntStream.range(0, 1 + random.nextInt(4))
                    .mapToObj(c -> component(
                            "C" + c,
                            random(random, "point", "proxy", "path"),
                            IntStream.range(0, random.nextInt(5))
                                    .mapToObj(w -> widget(
                                            "W" + w,
                                            random(random, "point", "proxy", "path"),
                                            random(random, "A", "B", "C", "D").split(" ")))
                                    .toList(),
                            random(random, "A", "B", "C", "D").split(" ")))
                    .toList();
            List<MarkupOption> wanted = options("A", "B", "C", "D");
            ComponentLibrary library = new ComponentLibrary(components, List.of());

            ChosenComponent chosen = new ComponentChoice(library, TYPES).choose(Purpose.SELECT, type("path"), wanted);

            assertThat(chosen.score()).isEqualTo(scoreByTheText(components, type("path"), wanted));
            if (chosen instanceof ChosenComponent.Direct direct) {
                List<Capabilities> used =
                        new ArrayList<>(List.of(direct.component().can()));
                direct.widgets().forEach(widget -> used.add(widget.can()));
                assertThat(used).anyMatch(can -> can.supports(Purpose.SELECT, type("path"), TYPES));
                assertThat(direct.actsOn()).allMatch(option -> used.stream().anyMatch(can -> can.actsOn(option)));
            }
        }
    }

    private static int scoreByTheText(List<ComponentType> components, ValueType type, List<MarkupOption> wanted) {
        int best = -1;
        for (ComponentType component : components) {
            List<Capabilities> all = new ArrayList<>(List.of(component.can()));
            component.widgets().forEach(widget -> all.add(widget.can()));
            if (all.stream().anyMatch(can -> can.supports(Purpose.SELECT, type, TYPES))) {
                int score = (int) wanted.stream()
                        .filter(option -> all.stream().anyMatch(can -> can.actsOn(option)))
                        .count();
                best = Math.max(best, score);
            }
        }
        return best;
    }

    /** Some of the words, at least one. */
    private static String random(Random random, String... words) {
        List<String> some = new ArrayList<>(
                List.of(words).stream().filter(word -> random.nextInt(3) == 0).toList());
        if (some.isEmpty()) {
            some.add(words[random.nextInt(words.length)]);
        }
        return String.join(" ", some);
    }
}
