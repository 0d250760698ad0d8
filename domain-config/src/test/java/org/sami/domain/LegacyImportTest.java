package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.legacy.CountedKind;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

class LegacyImportTest extends LegacyImportFixture {
    @Test
    void placesTransitionsEdgesAndLayoutKeepKeysOrderAndModes() {
        LegacyDocument.PlanPart made = document.plan("p1", "One");
        made.place("start").last().putArray("outTransitionOrder").add("t2").add("t1");
        made.place("a").last().put("mode", "HiddenRecovery").put("name", "Somewhere");
        made.place("end").last().put("isSharedSmEnd", true);
        made.transition("t1").last().putArray("inPlaceOrder").add("a").add("start");
        made.transition("t2").last().put("mode", "Recovery");
        made.in("start", "t1", "None - 0").in("a", "t1", "None - 0").in("start", "t2", "None - 0");
        made.out("t1", "end", "None - 0").out("t2", "end", "None - 0");

        Plan plan = plan();

        assertThat(plan.places()).extracting(p -> p.id()).containsExactly("start", "a", "end");
        assertThat(plan.startPlace().orElseThrow().transitionOrder()).containsExactly("t2", "t1");
        assertThat(plan.inEdgesOf("t1")).extracting(e -> e.place()).containsExactly("a", "start");
        assertThat(plan.place("a").orElseThrow().mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan.place("a").orElseThrow().name()).isEqualTo("Somewhere");
        assertThat(plan.place("end").orElseThrow().endsSharedInstance()).isTrue();
        assertThat(plan.transition("t2").orElseThrow().mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan.layout().get("a").y()).isEqualTo(20.0);
    }

    @ParameterizedTest
    @CsvSource({
        "Generic GreaterThanEqualTo 2, GENERIC, AT_LEAST, 2",
        "Generic LessThan 3, GENERIC, LESS_THAN, 3",
        "AnyProxy None -1, ANY_PROXY, ZERO, 0",
        "AnyTask Number 1, ANY_TASK, EXACTLY, 1",
        "AnyToken Number 0, ANY_TOKEN, ZERO, 0",
        "RelevantToken All -1, RELEVANT, ALL, 0",
        "None - 0, UNCONDITIONAL, ALL, 0",
        "SubMissionToken All 0, UNCONDITIONAL, ALL, 0",
        "AnyProxy All 0, ANY_PROXY, AT_LEAST, 1",
        "AnyProxy GreaterThanEqualTo 0, UNCONDITIONAL, ALL, 0",
    })
    void inRequirementsAreSaidInThisLanguage(String words, TokenKind kind, Match match, int n) {
        document.plan("p1", "One").place("start").transition("t").in("start", "t", words);

        assertThat(plan().inEdges().get(0).requirements()).containsExactly(new InRequirement(kind, match, n, ""));
    }

    @ParameterizedTest
    @CsvSource({
        "AnyToken All -1 Take, take all any-token",
        "Generic Number 3 Add, add 3 generic",
        "AnyProxy Number 1 Consume, consume 1 any-proxy",
        "RelevantToken Number 2 Take, take 2 relevant",
        "SubMissionToken All -1 Add, add all sub-mission-tokens",
        "Generic All -1 Add, add all generic",
        "None - 0, add all unconditional",
    })
    void outRequirementsAreSaidInThisLanguage(String words, String expected) {
        document.plan("p1", "One").transition("t").place("end").out("t", "end", words);

        OutRequirement r = plan().outEdges().get(0).requirements().get(0);
        String kind = r.kind().name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
        String action = r.action().name().toLowerCase(java.util.Locale.ROOT);
        assertThat(action + " " + (r.takesAll() ? "all" : r.n()) + " " + kind).isEqualTo(expected);
    }

    @Test
    void anEdgeWithoutRequirementsIsUnconditionalWithAWarning() {
        document.plan("p1", "One")
                .place("start")
                .transition("t")
                .in("start", "t")
                .out("t", "start");

        LegacyImport.Result result = result();

        Plan plan = result.project().orElseThrow().plans().get(0);
        assertThat(plan.inEdges().get(0).requirements()).containsExactly(InRequirement.unconditional());
        assertThat(plan.outEdges().get(0).requirements()).containsExactly(OutRequirement.unconditional());
        assertThat(codes(result)).filteredOn("W-NO-REQUIREMENT"::equals).hasSize(2);
        assertThat(result.source().of(CountedKind.IN_REQUIREMENTS)).isZero();
        assertThat(result.imported().of(CountedKind.IN_REQUIREMENTS)).isZero();
    }

    @Test
    void anEdgeDrawnTwiceIsOneWithTheRequirementsOfBoth() {
        document.plan("p1", "One")
                .place("start")
                .transition("t")
                .in("start", "t", "Generic Number 1")
                .in("start", "t", "AnyProxy None 0");

        LegacyImport.Result result = result();

        assertThat(result.project().orElseThrow().plans().get(0).inEdges())
                .singleElement()
                .satisfies(e -> assertThat(e.requirements()).hasSize(2));
        assertThat(result.explained().of(CountedKind.IN_EDGES)).isEqualTo(1);
        assertThat(codes(result)).contains("W-PARALLEL-EDGE");
    }

    @Test
    void secondsOfTheEarlierSystemAreDurations() {
        OutputEventSpec timer = outputOf(output(
                "sami.event.StartTimer",
                "'declaredFields': ['timerDuration'], 'fieldValues': {'timerDuration': " + INT_10
                        + "}, 'editable': {'timerDuration': true}"));

        assertThat(timer.type()).isEqualTo("StartSystemTimer");
        assertThat(timer.fields())
                .containsExactly(Map.entry(
                        "duration", new FieldSource.Asked(java.util.Optional.of(new DurationValue(10_000)), true)));
    }

    @Test
    void aLockedValueIsFixedAndAMissingOneIsAsked() {
        OutputEventSpec request = outputOf(output(
                "crw.event.output.service.AssembleLocationRequest",
                "'declaredFields': ['assemblyLocation', 'spacing'],"
                        + "'fieldValues': {'spacing': {'type': 'double', 'value': 3.0}, 'assemblyLocation': null},"
                        + "'editable': {'spacing': false}"));

        assertThat(request.fields().get("spacing")).isInstanceOf(FieldSource.Fixed.class);
        assertThat(request.fields().get("location")).isEqualTo(new FieldSource.Asked(java.util.Optional.empty(), true));
    }

    @Test
    void pathsAreListsOfLocationsWhereThoseAreWanted() {
        OutputEventSpec request = outputOf(output(
                "crw.event.output.service.DistributeLocationsRequest",
                "'fieldValues': {'locations': {'type': 'path', 'points': [{'type': 'location', 'lat': 1.0, 'lon': 2.0,"
                        + "'alt': 3.0}]}}, 'editable': {'locations': false}"));

        assertThat(request.fields().get("locations"))
                .isEqualTo(new FieldSource.Fixed(new org.sami.spn.value.ListValue(List.of(new GeoPoint(1, 2, 3)))));
    }

    @Test
    void aValueThatIsNoneHereIsAskedInsteadAndNamed() {
        document.plan("p1", "One")
                .place(
                        "start",
                        output(
                                "crw.event.output.proxy.ProxyExploreArea",
                                "'fieldValues': {'area': {'type': 'area', 'points': [{'lat': 100.0, 'lon': 2.0}]},"
                                        + "'spacing': {'type': 'double', 'value': 3.0}}"));

        LegacyImport.Result result = result();

        assertThat(codes(result)).contains("W-VALUE");
        assertThat(result.project()
                        .orElseThrow()
                        .plans()
                        .get(0)
                        .places()
                        .get(0)
                        .outputs()
                        .get(0)
                        .fields()
                        .get("area"))
                .isEqualTo(new FieldSource.Asked(java.util.Optional.empty(), true));
    }

    @Test
    void waitingForAllBoatsIsAPropertyOfTheTransition() {
        document.plan("p1", "One")
                .transition(
                        "each",
                        event(
                                "crw.event.input.proxy.ProxyPathCompleted",
                                "input",
                                "'fieldValues': {'blocking': {'type': 'bool', 'value': false}}"))
                .transition(
                        "all",
                        event(
                                "crw.event.input.proxy.ProxyPathCompleted",
                                "input",
                                "'fieldValues': {'blocking': {'type': 'bool', 'value': true}}"));

        assertThat(plan().transitions()).extracting(t -> t.waitFor()).containsExactly(WaitFor.EACH, WaitFor.ALL);
        assertThat(plan().transitions().get(1).inputs().get(0).fields()).isEmpty();
    }

    @Test
    void variablesAreDeclaredWithTheTypeOfTheFieldsThatUseThem() {
        document.global("@home", "sami.path.Location", "{'type': 'location', 'lat': 1.0, 'lon': 2.0, 'alt': 0.0}")
                .global("@wait", "java.lang.Integer", INT_10)
                .plan("p1", "One")
                .place(
                        "start",
                        output(
                                "crw.event.output.service.AssembleLocationRequest",
                                "'readVariables':"
                                        + "{'assemblyLocation': '@home'}, 'writeVariables': {'spacing': '@gap'},"
                                        + "'fieldValues': {'spacing': {'type': 'double', 'value': 3.0}}"),
                        output("sami.event.StartTimer", "'readVariables': {'timerDuration': '@wait'}"))
                .transition(
                        "t",
                        event(
                                "crw.event.input.service.AssembleLocationResponse",
                                "input",
                                "'writeVariables': {'proxyPoints': '@places'}"));

        Project project = result().project().orElseThrow();

        assertThat(project.globals())
                .containsExactly(
                        new VariableSpec("@home", ValueType.Simple.POINT, java.util.Optional.of(GeoPoint.of(1, 2))),
                        new VariableSpec(
                                "@wait", ValueType.Simple.DURATION, java.util.Optional.of(new DurationValue(10_000))));
        assertThat(project.plans().get(0).variables())
                .containsExactly(
                        new VariableSpec("@gap", ValueType.Simple.REAL, java.util.Optional.empty()),
                        new VariableSpec(
                                "@places",
                                new ValueType.MapOf(ValueType.Simple.PROXY, ValueType.Simple.POINT),
                                java.util.Optional.empty()));
    }

    @Test
    void anAreaKeepsItsCorners() {
        document.global(
                "@lake",
                "sami.area.Area2D",
                "{'type': 'area', 'points': [{'lat': 1.0, 'lon': 2.0},"
                        + "{'lat': 1.0, 'lon': 3.0}, {'lat': 2.0, 'lon': 3.0}]}");

        assertThat(result().project().orElseThrow().globals().get(0).initial().orElseThrow())
                .isInstanceOfSatisfying(
                        GeoArea.class, a -> assertThat(a.outline()).hasSize(3));
    }

    @Test
    void anEventOfAnUnknownClassIsKeptWholeAndNamed() {
        document.plan("p1", "One")
                .place("start", output("other.event.LaunchDrone", "'fieldValues': {'height': " + INT_10 + "}"))
                .transition("t", event("other.event.DroneLaunched", "input", "'declaredOutputs': ['drone']"));

        LegacyImport.Result result = result();

        Plan plan = result.project().orElseThrow().plans().get(0);
        OutputEventSpec kept = plan.places().get(0).outputs().get(0);
        assertThat(kept.type()).isEqualTo("UnknownRequest");
        assertThat(kept.fields().get("class"))
                .isEqualTo(new FieldSource.Fixed(new TextValue("other.event.LaunchDrone")));
        assertThat(kept.fields().get("content").toString()).contains("height");
        assertThat(plan.transitions().get(0).inputs().get(0).type()).isEqualTo("UnknownAnswer");
        assertThat(codes(result)).filteredOn("W-UNKNOWN-EVENT"::equals).hasSize(2);
    }

    @Test
    void aClassOfAnotherPackageIsTakenForItsNamesake() {
        OutputEventSpec message = outputOf(
                output("my.own.DisplayMessage", "'fieldValues': {'message': {'type': 'string', 'value': 'Hello'}}"));

        assertThat(message.type()).isEqualTo("DisplayMessage");
        assertThat(codes(result())).contains("N-BY-NAME");
    }

    @Test
    void anInputEventOnAPlaceIsNotImportedAndNamed() {
        document.plan("p1", "One")
                .place(
                        "start",
                        event("crw.event.input.operator.OperatorSelectsBoatList", "input", "'declaredFields': []"),
                        output("crw.event.output.operator.OperatorSelectBoatList", "'declaredFields': []"));

        LegacyImport.Result result = result();

        assertThat(result.project().orElseThrow().plans().get(0).places().get(0).outputs())
                .extracting(OutputEventSpec::type)
                .containsExactly("OperatorSelectBoatList");
        assertThat(result.explained().of(CountedKind.PLACE_EVENTS)).isEqualTo(1);
        assertThat(codes(result)).contains("W-EVENT-SIDE");
    }

    @Test
    void theProjectKeepsWhatTheImportSaid() {
        document.plan("p1", "One").place("start").transition("t").in("start", "t");

        Project project = result().project().orElseThrow();

        assertThat(project.importedFrom().orElseThrow().remarks())
                .singleElement()
                .satisfies(r -> {
                    assertThat(r.code()).isEqualTo("W-NO-REQUIREMENT");
                    assertThat(r.plan()).isEqualTo("p1");
                    assertThat(r.elements()).containsExactly("edge1");
                });
    }

    @Test
    void onlyRootsWithAStartPlaceAreToBeRun() {
        document.plan("p1", "--- HEADING ---");
        document.plan("p2", "One").place("start");
        document.plan("p3", "x.One").instance("p2").place("start").place("other");

        LegacyImport.Result result = result();

        assertThat(result.roots()).containsExactly("p2");
        assertThat(codes(result)).contains("W-HEADING");
    }
}
