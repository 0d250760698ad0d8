package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.legacy.CountedKind;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

class LegacyImportTest {
    private static final String CRW = "/org/sami/domain/crw";
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath(CRW).orThrow();
    private static final LegacyTable TABLE =
            LegacyTableReader.fromClassPath(CRW + "/legacy.json", VOCABULARY).orThrow();
    private static final String INT_10 = "{'type': 'int', 'class': 'java.lang.Integer', 'value': 10}";

    private final LegacyDocument document = new LegacyDocument();

    private LegacyImport.Result result() {
        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(document.text(), "made");
        assertThat(result.isAccountedFor())
                .as("%s%n%s%n%s", result.source(), result.imported(), result.explained())
                .isTrue();
        result.project()
                .ifPresent(p -> assertThat(new ProjectReader(VOCABULARY)
                                .read(new ProjectWriter(VOCABULARY).text(p))
                                .orThrow())
                        .isEqualTo(p));
        return result;
    }

    private Plan plan() {
        return result().project().orElseThrow().plans().get(0);
    }

    private static String event(String className, String direction, String members) {
        return "{'class': '" + className + "', 'direction': '" + direction + "', " + members + "}";
    }

    private static String output(String className, String members) {
        return event(className, "output", members);
    }

    private OutputEventSpec outputOf(String event) {
        document.plan("p1", "One").place("start", event);
        return plan().places().get(0).outputs().get(0);
    }

    private static List<String> codes(LegacyImport.Result result) {
        return result.findings().stream().map(Finding::code).toList();
    }

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
    void markupsKeepWhatTheyChoose() {
        OutputEventSpec message = outputOf(output(
                "crw.event.output.ui.DisplayMessage",
                "'fieldValues': {'message': {'type': 'string', 'value': 'Hello'}}, 'markups': ["
                        + "{'class': 'sami.markup.RelevantProxy', 'options': {'proxies': 'ALL_PROXIES', 'showPaths':"
                        + "'YES'}, 'parameters': {}},"
                        + "{'class': 'sami.markup.Keyword', 'options': {'text': 'SPECIFY'}, 'parameters': {'textOption':"
                        + "{'type': 'option', 'class': 'o', 'text': 'SK'}}},"
                        + "{'class': 'sami.markup.RelevantProxy', 'options': {}, 'parameters': {}},"
                        + "{'class': 'sami.markup.NeverHeardOf', 'options': {}, 'parameters': {}}]"));

        assertThat(message.markups())
                .extracting(m -> m.type() + m.options())
                .satisfiesExactly(
                        m -> assertThat(m).contains("ALL_PROXIES").contains("showPath=BooleanValue[value=true]"),
                        m -> assertThat(m).contains("SK"),
                        m -> assertThat(m).contains("RELEVANT_PROXIES"));
        assertThat(result().explained().of(CountedKind.MARKUPS)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "SortOptions | 'sortOrderEnum': 'ALPHABETICAL' | | method=ALPHABETICAL",
                "SortOptions | 'sortOrderEnum': 'CREATION_TIME' | | method=CHRONOLOGICAL",
                "SortOptions | 'sortMethodEnum': 'CHRONOLOGICAL', 'sortOrderEnum': 'DECREASING' | | method=CHRONOLOGICAL order=DECREASING",
                "Sort | 'method': 'Alphabetical', 'order': 'DESCENDING' | | method=ALPHABETICAL order=DECREASING",
                "Sort | 'sortMethod': 'ALPHABETICAL', 'increasing': false | | method=ALPHABETICAL order=DECREASING",
                "ProxyStatus | 'proxyStatus': 'SEVERE' | | status=SEVERE",
                "ProxyStatus | 'proxyStatusEnum': 'WARNING' | | status=WARNING",
                "ProxyStatus | 'status': 'NOMINAL' | | status=NOMINAL",
                "FilterOptions | 'filterMethodEnum': 'TEXT', 'includeMatchEnum': 'EXCLUDE' | 'textOption': {'type': 'option', 'text': 'SHORE'} | action=EXCLUDE source=SHORE",
                "FilterOptions | 'includeMatch': true | 'text': {'type': 'string', 'value': 'SHORE'} | action=INCLUDE source=SHORE",
                "Filter | 'exclude': true | 'textOption': {'type': 'option', 'text': 'SHORE'} | action=EXCLUDE source=SHORE",
                "Description | 'textSourceEnum': 'SPECIFY', 'showPlanNameEnum': 'YES', 'showVertexNameEnum': 'NO', 'showEventName': true | 'textOption': {'type': 'option', 'text': 'Go?'} | showEventName=true showPlanName=true showVertexName=false source=Go?",
                "Keyword | 'textSource': 'SPECIFY' | 'textOption': {'type': 'option', 'text': 'SK'} | source=SK",
                "Attention | 'attentionTypeEnum': 'BLINK', 'attentionEnd': 'ON_CLICK', 'attentionTarget': 'FRAME' | 'blink': {'type': 'option', 'cycleLength': 2000} | end=ON_CLICK target=COMPONENT type=BLINK",
                "DefaultSelection | 'selectionEnum': 'NONE' | | selection=NONE",
                "MixedInitiativeTrigger | 'trigger': 'TIMEOUT' | 'timeoutOption': {'type': 'option', 'timeout': 30} | timeout=30 s trigger=TIMER",
                "NumberOfOptions | 'number': 'SPECIFY', 'formatEnum': 'TABBED' | 'numberOption': {'type': 'option', 'number': 3} | format=TABS number=3",
                "SelectionOptions | 'number': 4, 'format': 'STACKED' | | format=STACKED number=4",
                "Optimize | 'criteriaEnum': 'EXECUTION_SAFETY' | | criteria=EXECUTION_SAFETY",
                "PhaseItem | 'phaseNameSourceEnum': 'SPECIFY', 'actorEnum': 'OPERATOR' | 'textOption': {'type': 'option', 'text': 'Search'} | actor=OPERATOR phaseName=Search",
                "PhaseBranch | 'actor': 'PROXY' | 'actionName': {'type': 'string', 'value': 'Turn'} | actionName=Turn actor=PROXY",
                "Priority | 'rankingEnum': 'CRITICAL' | | rank=CRITICAL",
                "Priority | 'rank': 'Low' | | rank=LOW",
                "RelevantArea | 'areaSelectionEnum': 'ALL_PROXIES', 'viewModification': 'EXPAND', 'mapTypeEnum': 'POLITICAL' | | mapType=POLITICAL modification=EXPAND source=ALL_PROXIES",
                "RelevantInformation | 'information': 'temperature', 'visualizationEnum': 'CONTOUR' | | source=temperature visualization=CONTOUR",
                "RelevantProxy | 'proxiesEnum': 'ALL_PROXIES', 'showPathsEnum': 'YES', 'showDiagnostic': true, 'showDataEnum': 'NO' | | proxy=ALL_PROXIES showData=false showDiagnostic=true showPath=true",
            })
    void everyOptionOfAMarkupArrivesHoweverItsFieldIsSpelled(
            String markup, String options, String parameters, String expected) {
        OutputEventSpec message = outputOf(withMarkup(markup, options, parameters == null ? "" : parameters));

        assertThat(message.markups()).hasSize(1);
        assertThat(message.markups().get(0).options().entrySet().stream()
                        .map(o -> o.getKey() + "=" + inWords(o.getValue()))
                        .sorted())
                .containsExactly(expected.split(" (?=[a-zA-Z]+=)"));
        assertThat(result().isComplete()).isTrue();
    }

    private static String inWords(Value value) {
        if (value instanceof EnumValue word) {
            return word.constant();
        }
        if (value instanceof DurationValue duration) {
            return duration.millis() / 1000 + " s";
        }
        String text = value.toString();
        return text.substring(text.indexOf('=') + 1, text.length() - 1);
    }

    private static String withMarkup(String markup, String options, String parameters) {
        return output(
                "crw.event.output.ui.DisplayMessage",
                "'fieldValues': {'message': {'type': 'string', 'value': 'Hello'}}, 'markups': [{'class': 'sami.markup."
                        + markup + "', 'options': {" + options + "}, 'parameters': {" + parameters + "}}]");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Priority | 'ranking': 'UNHEARD_OF', 'rank': 'LOW' | W-UNKNOWN-OPTION",
                "Priority | 'ranking': 'HIGH', 'colour': 'RED' | W-UNKNOWN-OPTION",
                "Keyword | 'textSourceEnum': 'SPECIFY' | W-UNKNOWN-MARKUP",
                "NeverHeardOf | 'a': 'B' | W-UNKNOWN-MARKUP",
            })
    void anImportThatLostAnOptionOrAMarkupIsNotComplete(String markup, String options, String code) {
        document.plan("p1", "One").place("start", withMarkup(markup, options, ""));

        LegacyImport.Result result = result();

        assertThat(result.losses()).extracting(Finding::code).containsExactly(code);
        assertThat(result.isComplete()).isFalse();
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

    private void copyWith(String copiesVariable, String copiesSecondVariable) {
        document.plan("p1", "Parent").place("start").runs("p2", false);
        document.plan("p2", "x.Child")
                .instance("p1")
                .place("start", assemble(copiesVariable))
                .transition("t", response(copiesSecondVariable))
                .in("start", "t", "None - 0");
        document.plan("p3", "Child")
                .place("start", assemble("@goal"))
                .transition("t", response("@found"))
                .in("start", "t", "None - 0");
    }

    private static String assemble(String variable) {
        return output(
                "crw.event.output.service.AssembleLocationRequest",
                "'readVariables': {'assemblyLocation': '" + variable
                        + "'}, 'fieldValues': {'spacing': {'type': 'double', 'value': 3.0}}");
    }

    private static String response(String variable) {
        return event(
                "crw.event.input.service.AssembleLocationResponse",
                "input",
                "'writeVariables': {'proxyPoints': '" + variable + "'}");
    }

    @Test
    void aTrueCopyBecomesAReferenceWithItsVariables() {
        copyWith("@x.goal", "@x.found");

        LegacyImport.Result result = result();

        Project project = result.project().orElseThrow();
        assertThat(project.plans()).extracting(Plan::id).containsExactly("p1", "p3");
        assertThat(project.plans().get(0).places().get(0).subMissions())
                .singleElement()
                .satisfies(s -> {
                    assertThat(s.plan()).isEqualTo("p3");
                    assertThat(s.variables()).isEqualTo(Map.of("@goal", "@x.goal", "@found", "@x.found"));
                });
        assertThat(project.plans().get(0).variables())
                .extracting(VariableSpec::name)
                .containsExactlyInAnyOrder("@x.goal", "@x.found");
        assertThat(result.explained().of(CountedKind.PLANS)).isEqualTo(1);
        assertThat(codes(result)).contains("N-COPY-FOLDED");
        assertThat(project.missionTree().get(0).children())
                .extracting(MissionTreeNode::plan)
                .containsExactly(java.util.Optional.of("p1"), java.util.Optional.of("p3"));
    }

    @Test
    void aCopyThatWasChangedStaysAPlanOfItsOwn() {
        copyWith("@x.goal", "@x.found");
        ((ObjectNode) document.root.at("/plans/1/vertices/0")).put("name", "Changed");

        LegacyImport.Result result = result();

        assertThat(result.project().orElseThrow().plans()).hasSize(3);
        assertThat(codes(result)).contains("N-COPY-KEPT");
    }

    @Test
    void aCopyInWhichTwoVariablesAreOneIsNoTrueCopy() {
        copyWith("@x.found", "@x.found");

        assertThat(result().project().orElseThrow().plans()).hasSize(3);
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

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''                                  | E-SYNTAX",
                "{\"format\": \"sami-leg              | E-SYNTAX",
                "[]                                  | E-WRONG-TYPE",
                "{}                                  | E-FORMAT",
                "{\"format\": \"sami\", \"version\": 1}   | E-FORMAT",
                "{\"format\": \"sami-legacy-project\"}  | E-VERSION",
                "{\"format\": \"sami-legacy-project\", \"version\": 2} | E-VERSION",
                "{\"format\": \"sami-legacy-project\", \"version\": \"1\"} | E-WRONG-TYPE",
                "{\"format\": \"sami-legacy-project\", \"version\": 1} | E-MISSING-MEMBER",
                "{\"format\": \"sami-legacy-project\", \"version\": 1, \"plans\": {}} | E-WRONG-TYPE",
                "{\"format\": \"sami-legacy-project\", \"version\": 1, \"plans\": [], \"plans\": []} | E-SYNTAX",
            })
    void aFileThatIsNoExportIsRefused(String text, String code) {
        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(text, "bad");

        assertThat(result.project()).isEmpty();
        assertThat(codes(result).get(0)).isEqualTo(code);
    }

    @ParameterizedTest
    @CsvSource({
        "/plans/0/vertices/0, type, road, E-UNKNOWN-WORD",
        "/plans/0/vertices/0, mode, Sleepy, E-UNKNOWN-WORD",
        "/plans/0/vertices/1, key, start, E-DUPLICATE",
        "/plans/0/edges/0, from, nowhere, E-DANGLING",
        "/plans/0/edges/0, type, across, E-UNKNOWN-WORD",
        "/plans/0/edges/0/requirements/0, kind, Sometimes, E-UNKNOWN-WORD",
        "/plans/0/edges/0/requirements/0, match, Most, E-UNKNOWN-WORD",
        "/plans/0/edges/1/requirements/0, action, Lend, E-UNKNOWN-WORD",
        "/plans/0, role, leaf, E-UNKNOWN-WORD",
        "/plans/0, vertices, none, E-WRONG-TYPE",
        "/missionTree/children/0, plan, p9, E-DANGLING",
        "/plans/0/vertices/0/subMissions/0, plan, p9, E-DANGLING",
        "/plans/0/vertices/0/events/0, direction, up, E-UNKNOWN-WORD",
    })
    void aDamagedExportIsRefusedWithThePlaceOfTheDamage(String where, String member, String word, String code) {
        document.plan("p1", "One")
                .place("start", output("sami.event.GetAllProxyTokens", "'declaredFields': []"))
                .runs("p1", false)
                .transition("t")
                .in("start", "t", "None - 0")
                .out("t", "start", "Generic Number 1 Take");
        ((ObjectNode) document.root.at(where)).put(member, word);

        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(document.text(), "bad");

        assertThat(result.project()).isEmpty();
        assertThat(result.findings())
                .filteredOn(f -> f.code().equals(code))
                .anySatisfy(f -> assertThat(f.pointer()).isEqualTo(where + "/" + member));
    }

    @Test
    void whatTheFormatDoesNotHaveIsNotLostInSilence() {
        document.plan("p1", "One").place("start").last().put("colour", "red");

        assertThat(result().findings())
                .anySatisfy(f -> assertThat(f.pointer()).isEqualTo("/plans/0/vertices/0/colour"));
    }
}
