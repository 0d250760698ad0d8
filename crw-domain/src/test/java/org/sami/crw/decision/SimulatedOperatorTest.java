package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.service.Geodesy;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

class SimulatedOperatorTest {
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final GeoPoint CENTRE = GeoPoint.of(45.6, 10.68);
    private static final ValueType POINTS = new ValueType.ListOf(ValueType.Simple.POINT);

    @Test
    void withoutRulesItChoosesAllSaysYesAndTakesTheFirst() {
        SimulatedOperator operator = operator(1, "");

        assertThat(answer(operator, new Question.Approve())).isEqualTo(new Answer.YesNo(true));
        assertThat(answer(operator, new Question.ChooseProxies(List.of("a", "b"), 1, 9)))
                .isEqualTo(new Answer.Proxies(List.of("a", "b")));
        assertThat(answer(operator, new Question.ChooseProxies(List.of("a", "b"), 1, 1)))
                .isEqualTo(new Answer.Proxies(List.of("a")));
        assertThat(answer(operator, new Question.ChooseOption(List.of(new TextValue("x")))))
                .isEqualTo(new Answer.Option(0));
        assertThat(answer(operator, new Question.ChooseOption(List.of()))).isEqualTo(new Answer.Rejected());
    }

    @Test
    void itMarksLocationsInItsSquareTheSameForTheSameSeed() {
        List<GeoPoint> first = locations(operator(1, ""));

        assertThat(first).hasSize(20).doesNotHaveDuplicates();
        assertThat(first)
                .allSatisfy(
                        point -> assertThat(Geodesy.distanceM(CENTRE, point)).isLessThan(600 / Math.sqrt(2) + 0.1));
        assertThat(locations(operator(1, ""))).isEqualTo(first);
        assertThat(locations(operator(2, ""))).isNotEqualTo(first);
    }

    @Test
    void theLocationsDoNotDependOnWhatElseWasAskedBefore() {
        SimulatedOperator operator = operator(1, "");
        fields(operator, item("where", ValueType.Simple.POINT, Optional.empty()));

        assertThat(locations(operator)).isEqualTo(locations(operator(1, "")));
    }

    @Test
    void aSecondListOfLocationsDiffersFromTheFirst() {
        SimulatedOperator operator = operator(1, "");

        assertThat(locations(operator)).isNotEqualTo(locations(operator));
    }

    @Test
    void everyBoatThatItKnowsGetsAShareOfItsOwn() {
        ValueType shares = new ValueType.MapOf(ValueType.Simple.PROXY, ValueType.Simple.POINT);
        SimulatedOperator knowing = new SimulatedOperator(
                VOCABULARY, new DefaultAnswers(CENTRE, CENTRE, 600, 20, 1, List.of("a", "b")), AnswersFile.EMPTY);

        Value given = fields(knowing, item("points", shares, Optional.empty())).get("points");

        assertThat(((MapValue) given).entries().keySet()).containsExactly(new ProxyValue("a"), new ProxyValue("b"));
        assertThat(((MapValue) given).entries().values())
                .doesNotHaveDuplicates()
                .allMatch(GeoPoint.class::isInstance);
    }

    @Test
    void whereOneBoatIsAskedForItNamesOneOfTheFleet() {
        SimulatedOperator knowing = new SimulatedOperator(
                VOCABULARY, new DefaultAnswers(CENTRE, CENTRE, 600, 20, 1, List.of("a", "b")), AnswersFile.EMPTY);

        assertThat(fields(knowing, item("robot", ValueType.Simple.PROXY, Optional.empty())))
                .containsEntry("robot", new ProxyValue("b"));
    }

    @Test
    void itKeepsDefaultsAndSaysWhatItCannotAnswer() {
        SimulatedOperator operator = operator(1, "");
        Question.Item every = item("every", ValueType.Simple.DURATION, Optional.of(new DurationValue(5000)));

        assertThat(fields(operator, every)).containsEntry("every", new DurationValue(5000));
        Reading<Answer> reading = operator.answer(
                decision("", new Question.FillIn(List.of(item("name", ValueType.Simple.TEXT, Optional.empty())))),
                "clv");
        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::message)
                .first()
                .asString()
                .contains("\"name\"");
    }

    @Test
    void rulesComeFirstByEventPlanAndCount() {
        SimulatedOperator operator = operator(1, """
                {"event": "OperatorApprove", "plan": "other", "answer": {"yes": true}},
                {"event": "OperatorApprove", "nth": 2, "answer": {"silent": true}},
                {"event": "OperatorApprove", "plan": "clv", "nth": 1, "answer": {"yes": false}},
                {"event": "OperatorSelectRobotList", "answer": {"boats": ["b"]}},
                {"event": "OperatorAllocationOptions", "nth": 1, "answer": {"reject": true}}
                """);

        Decision approve = decision("OperatorApprove", new Question.Approve());
        assertThat(operator.answer(approve, "clv").result()).contains(new Answer.YesNo(false));
        Reading<Answer> silent = operator.answer(approve, "clv");
        assertThat(silent.result()).isEmpty();
        assertThat(silent.findings()).isEmpty();
        assertThat(operator.answer(approve, "clv").result()).contains(new Answer.YesNo(true));

        Decision select = decision("OperatorSelectBoatList", new Question.ChooseProxies(List.of("a", "b"), 1, 9));
        assertThat(operator.answer(select, "clv").result()).contains(new Answer.Proxies(List.of("b")));

        Decision options =
                decision("OperatorAllocationOptions", new Question.ChooseOption(List.of(new TextValue("x"))));
        assertThat(operator.answer(options, "clv").result()).contains(new Answer.Rejected());
        assertThat(operator.answer(options, "clv").result()).contains(new Answer.Option(0));
    }

    @Test
    void valuesOfARuleAreReadByTheirType() {
        SimulatedOperator operator = operator(1, """
                {"event": "OperatorCreateLocations", "answer": {"values": {"locations": [{"lat": 45.6, "lon": 10.68}, {"lat": 45.601, "lon": 10.68}]}}},
                {"event": "start:distance", "plan": "station-keep", "answer": {"value": 12.5}}
                """);

        Question.FillIn create = new Question.FillIn(List.of(item("locations", POINTS, Optional.empty())));
        Answer given = operator.answer(decision("OperatorCreateLocations", create), "clv")
                .orThrow();
        assertThat(((ListValue) ((Answer.Fields) given).values().get("locations")).items())
                .containsExactly(CENTRE, GeoPoint.of(45.601, 10.68));

        Question.FillIn start = new Question.FillIn(List.of(
                item("compare.distance", ValueType.Simple.REAL, Optional.of(new RealValue(10))),
                item("compare.other", ValueType.Simple.REAL, Optional.of(new RealValue(3)))));
        Answer parameters = operator.answer(decision("", start), "station-keep").orThrow();
        assertThat(((Answer.Fields) parameters).values())
                .containsEntry("compare.distance", new RealValue(12.5))
                .containsEntry("compare.other", new RealValue(3));
    }

    @Test
    void aRuleThatDoesNotFitWhatIsAskedIsAFindingWithItsPlace() {
        SimulatedOperator operator = operator(1, """
                {"event": "OperatorSelectBoatList", "nth": 1, "answer": {"boats": ["zeppelin"]}},
                {"event": "OperatorSelectBoatList", "answer": {"boats": 0}},
                {"event": "OperatorAllocationOptions", "answer": {"option": 3}},
                {"event": "start:distance", "answer": {"value": "far"}}
                """);
        Decision select = decision("OperatorSelectBoatList", new Question.ChooseProxies(List.of("a"), 1, 9));

        assertFinding(operator.answer(select, "clv"), "/rules/0/answer", "zeppelin");
        assertFinding(operator.answer(select, "clv"), "/rules/1/answer", "[]");
        assertFinding(
                operator.answer(
                        decision("OperatorAllocationOptions", new Question.ChooseOption(List.of(new TextValue("x")))),
                        "clv"),
                "/rules/2/answer",
                "3");
        assertFinding(
                operator.answer(
                        decision(
                                "",
                                new Question.FillIn(
                                        List.of(item("c.distance", ValueType.Simple.REAL, Optional.empty())))),
                        "clv"),
                "/rules/3/answer/value",
                "");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "{\"event\": \"Nonsense\", \"answer\": {}}|/rules/0/event|Nonsense",
                "{\"event\": \"DisplayMessage\", \"answer\": {}}|/rules/0/event|asks the operator nothing",
                "{\"event\": \"OperatorApprove\", \"answer\": {\"boats\": []}}|/rules/0/answer|[yes, silent]",
                "{\"event\": \"OperatorApprove\", \"answer\": {\"yes\": \"ja\"}}|/rules/0/answer/yes|true or false",
                "{\"event\": \"OperatorApprove\", \"answer\": 5}|/rules/0/answer|object",
                "{\"event\": \"OperatorApprove\"}|/rules/0/answer|missing",
                "{\"event\": \"OperatorApprove\", \"nth\": 0, \"answer\": {\"yes\": true}}|/rules/0/nth|counts from 1",
                "{\"event\": \"OperatorApprove\", \"who\": 1, \"answer\": {\"yes\": true}}|/rules/0/who|who",
                "{\"event\": 5, \"answer\": {}}|/rules/0/event|text",
                "7|/rules/0|object",
                "{\"event\": \"OperatorSelectBoat\", \"answer\": {\"boats\": \"some\"}}|/rules/0/answer/boats|all",
                "{\"event\": \"OperatorAllocationOptions\", \"answer\": {\"option\": -1}}|/rules/0/answer/option|from 0",
                "{\"event\": \"OperatorCreateLocations\", \"answer\": {\"values\": {\"l\": 1}}}|/rules/0/answer/values/l|no field",
                "{\"event\": \"OperatorCreateLocations\", \"answer\": {\"values\": {\"locations\": [{\"lat\": 95, \"lon\": 0}]}}}|/rules/0/answer/values/locations/0|",
                "{\"event\": \"start:x\", \"answer\": {\"values\": {}}}|/rules/0/answer|[value]",
            })
    void nonsenseInAFileIsNamedWithItsPlace(String rule, String pointer, String words) {
        Reading<AnswersFile> reading = AnswersFileReader.read(file(rule), VOCABULARY);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings()).isNotEmpty();
        assertThat(reading.findings().get(0).pointer()).startsWith(pointer);
        assertThat(reading.findings().get(0).message()).contains(words == null ? "" : words);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "{|E-SYNTAX",
                "[]|E-WRONG-TYPE",
                "{\"format\": \"crw-answers\", \"version\": 2, \"rules\": []}|E-VERSION",
                "{\"format\": \"recipe\", \"version\": 1, \"rules\": []}|E-VERSION",
                "{\"format\": \"crw-answers\", \"version\": 1}|E-WRONG-TYPE",
                "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [], \"format\": \"a\"}|E-SYNTAX",
            })
    void aFileThatIsNoneIsRefused(String text, String code) {
        Reading<AnswersFile> reading = AnswersFileReader.read(text, VOCABULARY);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings()).extracting(Finding::code).contains(code);
    }

    @Test
    void settingsThatMakeNoSenseAreRefused() {
        assertThatThrownBy(() -> new DefaultAnswers(CENTRE, 0, 20, 1)).hasMessageContaining("0.0");
        assertThatThrownBy(() -> new DefaultAnswers(CENTRE, 600, -1, 1)).hasMessageContaining("-1");
    }

    private static void assertFinding(Reading<Answer> reading, String pointer, String words) {
        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings().get(0).pointer()).startsWith(pointer);
        assertThat(reading.findings().get(0).message()).contains(words);
    }

    private static List<GeoPoint> locations(SimulatedOperator operator) {
        Value marked =
                fields(operator, item("locations", POINTS, Optional.empty())).get("locations");
        return ((ListValue) marked).items().stream().map(GeoPoint.class::cast).toList();
    }

    private static Map<String, Value> fields(SimulatedOperator operator, Question.Item item) {
        return ((Answer.Fields) answer(operator, new Question.FillIn(List.of(item)))).values();
    }

    private static Answer answer(SimulatedOperator operator, Question question) {
        return operator.answer(decision("", question), "clv").orThrow();
    }

    private static Question.Item item(String key, ValueType type, Optional<Value> defaultValue) {
        return new Question.Item(key, type, "", defaultValue, true, "");
    }

    private static SimulatedOperator operator(long seed, String rules) {
        AnswersFile answers = AnswersFileReader.read(file(rules), VOCABULARY).orThrow();
        return new SimulatedOperator(VOCABULARY, new DefaultAnswers(CENTRE, 600, 20, seed), answers);
    }

    private static String file(String rules) {
        return "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [" + rules + "]}";
    }

    private static Decision decision(String type, Question question) {
        return new Decision(
                1, 1, 1, type, "?", question, Optional.empty(), OptionalLong.empty(), Priority.MEDIUM, List.of());
    }
}
