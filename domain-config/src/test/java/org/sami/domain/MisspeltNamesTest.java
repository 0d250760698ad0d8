package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** What is said of a name that nearly is one, other names of events, and durations with their units. */
class MisspeltNamesTest {
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();

    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p",
              "variables": [{"name": "@x", "type": "list<point>"}],
              "tasks": [{"name": "T", "class": "Camera"}],
              "places": [
                {"id": "s", "start": true, "outputs": [
                  {"id": "o1", "type": "OperatorSelectRobotList",
                   "markups": [{"type": "NumberOfOptions", "options": {"number": 2}}]},
                  {"id": "o2", "type": "StartTimer", "fields": {"duration": {"value": "90 s"}}},
                  {"id": "o3", "type": "GenerateTasks",
                   "fields": {"locations": {"value": []}, "taskClass": {"value": "Temperature"}}}]},
                {"id": "e", "end": true}],
              "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "TimerExpired"}]}],
              "inEdges": [{"id": "a", "place": "s", "transition": "t",
                "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
              "outEdges": [{"id": "b", "transition": "t", "place": "e",
                "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]}]}
            """;

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    OperatorSelectRobotList | OperatorSelectRobtList | is OperatorSelectRobotList or
                    "TimerExpired"          | "TimrExpired"          | is TimerExpired meant?
                    NumberOfOptions         | NumberOfOption         | is NumberOfOptions meant?
                    "number"                | "numbr"                | is number meant?
                    "Camera"                | "Camra"                | is Camera meant?
                    list<point>             | list<poin>             | is point meant?
                    list<point>             | list<Alocation>        | is Allocation meant?
                    "Temperature"           | "Temprature"           | there are Temperature, Camera
                    "duration"              | "duraton"              | it has duration
                    """)
    void aNameThatIsNearlyOneIsAnsweredWithThatOne(String right, String wrong, String said) {
        String misspelt = PLAN.replace(right, wrong);
        assertThat(misspelt).isNotEqualTo(PLAN);

        Reading<Project> reading = new ProjectReader(VOCABULARY).readAndCheck(misspelt);

        assertThat(reading.findings())
                .as("what is said of " + wrong)
                .extracting(Finding::message)
                .anyMatch(message -> message.contains(said));
        assertThat(reading.findings()).noneMatch(finding -> finding.pointer().isEmpty());
    }

    @Test
    void otherNamesAreReadAndWrittenBackAsTheNamesOfTheAppendix() {
        String written = new ProjectWriter(VOCABULARY)
                .text(new ProjectReader(VOCABULARY).read(PLAN).orThrow());

        assertThat(written)
                .contains("OperatorSelectBoatList", "StartSystemTimer", "SelectionOptions")
                .doesNotContain("OperatorSelectRobotList", "StartTimer", "NumberOfOptions");
    }

    @ParameterizedTest
    @CsvSource({
        "90 s, PT1M30S",
        "5000 ms, PT5S",
        "5000ms, PT5S",
        "0.5 s, PT0.5S",
        "2 min, PT2M",
        "1.5 h, PT1H30M",
        "PT10S, PT10S"
    })
    void aDurationIsReadWithItsUnitAndWrittenInOneForm(String given, String written) {
        Project project =
                new ProjectReader(VOCABULARY).read(PLAN.replace("90 s", given)).orThrow();

        assertThat(new ProjectWriter(VOCABULARY).text(project)).contains("\"" + written + "\"");
    }

    @ParameterizedTest
    @CsvSource({"\"90\"", "90", "\"90 sec\"", "\"0.1 ms\"", "\"-5 s\"", "\"999999999999 h\""})
    void aDurationWithoutAUnitThatIsKnownIsRefused(String given) {
        Reading<Project> reading = new ProjectReader(VOCABULARY).read(PLAN.replace("\"90 s\"", given));

        assertThat(reading.result()).isEmpty();
        List<Finding> findings = reading.findings();
        assertThat(findings).hasSize(1);
        assertThat(findings.get(0).message()).contains("PT10S");
    }
}
