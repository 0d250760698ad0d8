package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.pattern.Pattern;
import org.sami.spn.pattern.PatternSpot;
import org.sami.spn.pattern.Patterns;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.testing.PlayedTasks;
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** Each pattern draws a plan that passes all checks and that runs as the pattern says, and is one step to undo. */
class PatternsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final AuthoringLibrary LIBRARY = BOATS.authoring();

    private EditHistory history = history(new PlanBuilder("p").build());

    private static EditHistory history(Plan plan) {
        return history(new Project("project", "", "crw", List.of(), List.of(), List.of(plan)));
    }

    private static EditHistory history(Project project) {
        return new EditHistory(project, BOATS.vocabulary(), 100);
    }

    private Plan plan() {
        return history.project().plans().get(0);
    }

    private void done(Edit edit) {
        EditResult result = history.apply(edit);
        assertThat(result).as("%s", result).isInstanceOf(EditResult.Done.class);
    }

    private static Pattern pattern(String id) {
        return Patterns.of(LIBRARY).stream()
                .filter(p -> p.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private PatternSpot spot(String... selected) {
        return new PatternSpot(history.project(), plan(), Set.of(selected), Mode.NOMINAL, BOATS.vocabulary(), LIBRARY);
    }

    /** Draws a pattern, and sees that it is undone as one. */
    private void draw(String pattern, String... selected) {
        PatternSpot spot = spot(selected);
        assertThat(pattern(pattern).refusal(spot)).isEmpty();
        Project before = history.project();
        done(pattern(pattern).edit(spot));
        Project after = history.project();
        history.undo();
        assertThat(history.project()).isEqualTo(before);
        history.redo();
        assertThat(history.project()).isEqualTo(after);
    }

    private void first(String event) {
        done(AddEvent.usual(
                "p", event, new EventTarget.Free(Optional.of(new LayoutPoint(60, 200))), Mode.NOMINAL, LIBRARY));
    }

    private void behind(String answer, String event) {
        onto(placeBehind(answer), event);
    }

    private void onto(String place, String event) {
        AddEvent usual = AddEvent.usual("p", event, new EventTarget.OnVertex(place), Mode.NOMINAL, LIBRARY);
        boolean each = LIBRARY.of(event).stream().anyMatch(s -> s.id().equals(Gathering.EACH.id()));
        done(each ? usual.withSequence(Gathering.EACH.id()) : usual);
    }

    private String transition(String answer) {
        List<String> all = plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(answer)))
                .map(t -> t.id())
                .toList();
        return all.get(all.size() - 1);
    }

    private String placeBehind(String answer) {
        return plan().outEdgesOf(transition(answer)).get(0).place();
    }

    private String place(String output) {
        return plan().places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals(output)))
                .findFirst()
                .orElseThrow()
                .id();
    }

    private String named(String name) {
        return plan().places().stream()
                .filter(p -> p.name().equals(name))
                .findFirst()
                .orElseThrow()
                .id();
    }

    private String transitionNamed(String name) {
        return plan().transitions().stream()
                .filter(t -> t.name().equals(name))
                .findFirst()
                .orElseThrow()
                .id();
    }

    private void set(String output, String field, Value value) {
        String event = plan().place(place(output)).orElseThrow().outputs().stream()
                .filter(o -> o.type().equals(output))
                .findFirst()
                .orElseThrow()
                .id();
        done(new FieldEdit.SetField("p", event, field, new FieldSource.Fixed(value)));
    }

    /** What an answer leads to instead of its own place. */
    private void lead(String answer, String place) {
        String transition = transition(answer);
        done(new RemoveElements("p", Set.of(placeBehind(answer))));
        done(new EdgeEdit.Connect("p", transition, place, Mode.NOMINAL));
        String edge = plan().outEdgesOf(transition).get(0).id();
        done(new EdgeEdit.SetOutRequirements(
                "p", edge, List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
    }

    private List<Finding> findings() {
        return PlanChecks.check(history.project(), BOATS.vocabulary());
    }

    private PlayedTeam team(int boats, long seed) {
        return new PlayedTeam(history.project(), BOATS.vocabulary(), boats, seed);
    }

    // ---- When all are here

    /** Chosen boats go to a first and a second point, and meet there; who cannot go on goes there as well. */
    private void twoLegs() {
        first("OperatorSelectBoatList");
        behind("OperatorSelectsBoatList", "AssembleLocationRequest");
        set("AssembleLocationRequest", "location", new GeoPoint(43.6, -79.4, 0));
        set("AssembleLocationRequest", "spacing", new RealValue(5));
        behind("AssembleLocationResponse", "ProxyGotoPoint");
        String second = placeBehind("ProxyPathCompleted");
        String failed = placeBehind("ProxyPathFailed");
        onto(second, "ProxyGotoPoint");
        String here = placeBehind("ProxyPathCompleted");
        lead("ProxyPathFailed", here);
        String firstFailed = plan().outEdges().stream()
                .filter(e -> e.place().equals(failed))
                .findFirst()
                .orElseThrow()
                .transition();
        done(new RemoveElements("p", Set.of(failed)));
        done(new EdgeEdit.Connect("p", firstFailed, here, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(firstFailed).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        done(new VertexEdit.NameVertex("p", here, "Here"));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void allGoOnTogetherWhenTheLastHasComeFromEveryPlaceBefore(long seed) {
        twoLegs();
        draw("when-all-are-here", named("Here"));
        done(new VertexEdit.SetEnd("p", named("All together"), true, false));
        assertThat(findings()).isEmpty();

        PlayedTeam team = team(4, seed)
                .decides("OperatorSelectBoatList", d -> new Answer.Proxies(List.of("b1", "b2", "b3")))
                .once("AssembleLocationRequest", "AssembleLocationResponse", PatternsTest::points)
                .each("ProxyGotoPoint", "ProxyPathCompleted");

        assertThat(team.run("p")).as("b4 was not chosen and is not waited for").contains(Outcome.ENDED);
        List<String> arrivals = plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals("ProxyPathCompleted")))
                .map(t -> t.id())
                .toList();
        assertThat(team.fired(arrivals.get(0)) + team.fired(arrivals.get(1))).isEqualTo(6);
        assertThat(team.fired(transitionNamed("All are here"))).isEqualTo(1);
    }

    /** Thesis, 9.1.2, with all tasks allocated at the same time: a boat that has several takes part in several rounds. */
    @ParameterizedTest
    @CsvSource({"3, 3, 1", "5, 5, 1", "5, 4, 2", "3, 1, 3"})
    void picturesAreTakenTogetherInAsManyRoundsAsABoatHasTasks(int locations, int boats, int rounds) {
        panorama();
        String taking = place("TakePanorama");
        String arrived = transition("ProxyPathCompleted");
        String here = "here";
        done(new RemoveElements("p", Set.of(plan().outEdgesOf(arrived).get(0).id())));
        done(new VertexEdit.AddPlace(
                "p",
                new Place(here, "Here", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.empty()));
        done(new EdgeEdit.Connect("p", arrived, here, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(arrived).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        draw("when-all-are-here", here);
        String together = transitionNamed("All are here");
        done(new RemoveElements("p", Set.of(named("All together"))));
        done(new EdgeEdit.Connect("p", together, taking, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(together).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TASK))));
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));

        PlayedTeam team = camera(locations, boats, 1);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.fired(together)).isBetween((long) rounds, (long) locations);
        assertThat(team.fired(transition("TaskCompleted"))).isEqualTo(locations);
    }

    @Test
    void onlyTheSelectedPlacesMustBeEmptyWhereTheAuthorSaysWhich() {
        twoLegs();
        String secondLeg = plan().places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals("ProxyGotoPoint")))
                .map(Place::id)
                .reduce((a, b) -> b)
                .orElseThrow();
        draw("when-all-are-here", named("Here"), secondLeg);

        assertThat(plan().inEdgesOf(transitionNamed("All are here")))
                .extracting(e -> e.place())
                .containsExactly(named("Here"), secondLeg);
    }

    private static Map<String, Value> points(Activation asked) {
        Map<Value, Value> points = new LinkedHashMap<>();
        asked.proxies().forEach(p -> points.put(new ProxyValue(p), new GeoPoint(43.6, -79.4, 0)));
        return Map.of("points", new MapValue(points));
    }

    // ---- Until none is left, autonomy decides at once, ask again on no

    /** The asynchronous panorama plan of the thesis, 9.1.2, as its additions draw it. */
    private void panorama() {
        first("OperatorCreateLocations");
        behind("OperatorCreatesLocations", "GenerateTasks");
        set("GenerateTasks", "taskClass", new TextValue("Camera"));
        behind("TasksGenerated", "AllocationRequest");
        behind("AllocationResponse", "OperatorAllocationOptions");
        behind("OperatorAcceptedAllocation", "ApplyAllocation");
        done(AddEvent.usual(
                "p",
                "TaskStarted",
                new EventTarget.Behind(placeBehind("OperatorAcceptedAllocation")),
                Mode.NOMINAL,
                LIBRARY));
        behind("TaskStarted", "ProxyGotoLatLon");
        behind("ProxyPathCompleted", "TakePanorama");
        behind("PanoramaTaken", "StartProxyTimer");
        set("StartProxyTimer", "duration", new DurationValue(5000));
        behind("ProxyTimerExpired", "TaskComplete");
        done(new VertexEdit.NameVertex("p", placeBehind("TaskCompleted"), "Finished"));
        lead("ProxyPathFailed", place("TaskComplete"));
        lead("PanoramaFailed", place("TaskComplete"));
    }

    private PlayedTeam camera(int locations, int boats, long seed) {
        return team(boats, seed)
                .decides(
                        "OperatorCreateLocations",
                        d -> new Answer.Fields(Map.of("locations", PlayedTasks.locations(locations))))
                .once(
                        "AllocationRequest",
                        "AllocationResponse",
                        a -> Map.of("allocations", PlayedTasks.allocations(a, boats)))
                .works("TaskStarted", "TaskComplete")
                .each("ProxyGotoLatLon", "ProxyPathCompleted")
                .each("TakePanorama", "PanoramaTaken")
                .each("TaskComplete", "TaskCompleted");
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 3", "5, 2", "5, 5", "3, 1"})
    void missionEndsWhenNoTaskIsLeftAnywhere(int locations, int boats) {
        panorama();
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));
        assertThat(findings()).isEmpty();

        for (long seed = 1; seed <= 5; seed++) {
            PlayedTeam team = camera(locations, boats, seed);
            assertThat(team.run("p")).as("seed %d", seed).contains(Outcome.ENDED);
            assertThat(team.fired(transition("TaskCompleted"))).isEqualTo(locations);
            assertThat(team.fired(transitionNamed("None is left"))).isEqualTo(1);
        }
    }

    @Test
    void severalPlacesOfThoseWhoAreDoneEndThePlanTogether() {
        panorama();
        done(new RemoveElements(
                "p",
                Set.of(plan().outEdgesOf(transition("PanoramaFailed")).get(0).id())));
        done(new VertexEdit.AddPlace(
                "p",
                new Place("lost", "Lost", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.empty()));
        done(new EdgeEdit.Connect("p", transition("PanoramaFailed"), "lost", Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(transition("PanoramaFailed")).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));

        draw("until-none-is-left", named("Finished"), "lost");

        assertThat(findings()).isEmpty();
        assertThat(plan().places().stream().filter(Place::end)).hasSize(1);
        assertThat(camera(3, 3, 1).each("TakePanorama", "PanoramaFailed").run("p"))
                .contains(Outcome.ENDED);
        assertThat(camera(3, 3, 1).run("p")).contains(Outcome.ENDED);
    }

    @Test
    void autonomyAnswersWithoutTheOperator() {
        panorama();
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));

        PlayedTeam team = camera(2, 2, 1).decides("OperatorAllocationOptions", d -> {
            throw new AssertionError("the operator was asked");
        });

        team.run("p");
        assertThat(team.fired(transition("OperatorAcceptedAllocation"))).isEqualTo(1);
    }

    @Test
    void rejectedOptionsAreRequestedAnew() {
        panorama();
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));
        assertThat(findings()).isEmpty();
        int[] asked = {0};

        PlayedTeam team = camera(3, 3, 1)
                .decides(
                        "OperatorAllocationOptions",
                        d -> asked[0]++ < 2 ? new Answer.Rejected() : new Answer.Option(0));

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.asked().stream().filter(a -> a.type().equals("AllocationRequest")))
                .hasSize(3);
    }

    @Test
    void noLeadsBackToAQuestionOfYesOrNo() {
        first("OperatorApprove");
        draw("ask-again-on-no", place("OperatorApprove"));
        done(new VertexEdit.SetEnd("p", placeBehind("YesOption"), true, false));
        assertThat(findings()).isEmpty();
        int[] asked = {0};

        PlayedTeam team = team(1, 1).decides("OperatorApprove", d -> new Answer.YesNo(asked[0]++ >= 2));

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(asked[0]).isEqualTo(3);
    }

    // ---- Battery watch around this

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void boatWithALowBatteryWaitsForItsChangeAndIsWaitedFor(long seed) {
        history = history(BOATS.projectOf("explore-area").orElseThrow());
        List<Finding> before = findings();
        draw("battery-watch-around-this", "explore");
        assertThat(findings()).isEqualTo(before);
        Set<String> low = new java.util.HashSet<>();

        PlayedTeam team = team(3, seed)
                .decides(
                        "OperatorCreateArea",
                        d -> new Answer.Fields(Map.of(
                                "area",
                                new GeoArea(
                                        List.of(
                                                new GeoPoint(43.6, -79.4, 0),
                                                new GeoPoint(43.61, -79.4, 0),
                                                new GeoPoint(43.6, -79.41, 0)),
                                        List.of()))))
                .some(
                        "BatteryLevelSubscription",
                        "BatteryLow",
                        a -> a.proxies().contains("b2") && low.add("b2") ? List.of("b2") : List.of())
                .some(
                        "ProxyExploreArea",
                        "ProxyPathCompleted",
                        a -> a.proxies().stream()
                                .filter(p -> !p.equals("b2")
                                        || (low.contains("b2") && a.proxies().size() == 1))
                                .toList());

        assertThat(team.run("explore-area")).contains(Outcome.ENDED);
        assertThat(team.fired("explored")).isEqualTo(3);
        assertThat(team.fired(transitionNamed("Battery changed"))).isEqualTo(1);
    }

    /** Chosen boats go to a point and end there: all together, as the transition waits for all. */
    private void goTogether() {
        first("OperatorSelectBoatList");
        behind("OperatorSelectsBoatList", "AssembleLocationRequest");
        set("AssembleLocationRequest", "location", new GeoPoint(43.6, -79.4, 0));
        set("AssembleLocationRequest", "spacing", new RealValue(5));
        done(AddEvent.usual(
                        "p",
                        "ProxyGotoPoint",
                        new EventTarget.OnVertex(placeBehind("AssembleLocationResponse")),
                        Mode.NOMINAL,
                        LIBRARY)
                .withSequence(Gathering.WAIT_FOR_ALL.id()));
        done(new VertexEdit.SetEnd("p", placeBehind("ProxyPathCompleted"), true, false));
    }

    /** A team of three, of whom b2's battery is low once; it arrives only after that. */
    private PlayedTeam teamWithALowBattery(long seed) {
        Set<String> low = new java.util.HashSet<>();
        return team(3, seed)
                .decides("OperatorSelectBoatList", d -> new Answer.Proxies(List.of("b1", "b2", "b3")))
                .once("AssembleLocationRequest", "AssembleLocationResponse", PatternsTest::points)
                .some(
                        "BatteryLevelSubscription",
                        "BatteryLow",
                        a -> a.proxies().contains("b2") && low.add("b2") ? List.of("b2") : List.of())
                .some(
                        "ProxyGotoPoint",
                        "ProxyPathCompleted",
                        a -> a.proxies().stream()
                                .filter(p -> !p.equals("b2") || a.proxies().size() == 1)
                                .toList());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void whoWaitsForAllWaitsForABoatWhoseBatteryIsChanged(long seed) {
        goTogether();
        draw("battery-watch-around-this", place("ProxyGotoPoint"));

        PlayedTeam team = teamWithALowBattery(seed);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.firedOf(transitionNamed("Battery changed"), transition("ProxyPathCompleted")))
                .as("b2 comes back before the others go on")
                .containsExactly(transitionNamed("Battery changed"), transition("ProxyPathCompleted"));
    }

    @Test
    void whoeverTakesAllAlongTakesABoatWhoseBatteryIsChanged() {
        history = history(BOATS.projectOf("station-keep").orElseThrow());
        draw("battery-watch-around-this", "hold");
        String away = named("Change the battery");

        assertThat(plan().inEdges().stream().filter(e -> e.place().equals(away)).map(e -> e.transition()))
                .contains("finish", "stop")
                .doesNotContain("time-to-look");
    }

    @Test
    void watchSaysWhereItCannotStand() {
        history = history(BOATS.projectOf("explore-area").orElseThrow());

        assertThat(pattern("battery-watch-around-this").refusal(spot("end"))).contains("The mission ends in \"End\"");
        assertThat(pattern("battery-watch-around-this").refusal(spot("explore", "wait")))
                .contains("Select one place where robots work");
        draw("battery-watch-around-this", "explore");
        assertThat(pattern("battery-watch-around-this").refusal(spot("explore")))
                .contains("\"Explore\" is watched already");
    }

    @Test
    void patternsSayWhatToSelect() {
        first("OperatorCreateLocations");
        String last = placeBehind("OperatorCreatesLocations");

        assertThat(pattern("when-all-are-here").refusal(spot(last)))
                .contains("Neither robots nor tasks come to \"place 2\"");
        assertThat(pattern("until-none-is-left").refusal(spot(place("OperatorCreateLocations"))))
                .contains("Select the place where they are when they are done: nothing leads out of it");
        assertThat(pattern("ask-again-on-no").refusal(spot(last))).isPresent();
        assertThat(pattern("autonomy-decides-at-once").refusal(spot(last))).isPresent();
        for (Pattern pattern : Patterns.of(LIBRARY)) {
            assertThat(pattern.refusal(spot())).as(pattern.id()).isPresent();
            assertThat(pattern.help()).endsWith(".");
        }
    }
}
