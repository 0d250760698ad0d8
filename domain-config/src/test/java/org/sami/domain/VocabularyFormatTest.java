package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.Vocabulary;

/** The vocabulary's format: one small good domain, and what is refused of it. */
class VocabularyFormatTest {
    private static final String CRW = "/org/sami/domain/crw";
    private static final String INDEX = """
            {"formatVersion": 1, "domain": "d", "label": "D", "files": ["words.json"]}""";
    private static final String WORDS = """
            {
              "types": [
                {"enum": "Colour", "constants": ["RED", "GREEN"]},
                {"record": "Offer", "fields": {"price": "real", "colour": "Colour"}}
              ],
              "events": [
                {"name": "Ask", "aliases": ["Question"], "direction": "output", "label": "Ask", "help": "Asks.",
                 "tokens": "proxy", "flags": ["command"],
                 "fields": [{"name": "offers", "type": "list<Offer>", "unit": "", "help": "What is offered."},
                            {"name": "colour", "type": "Colour", "default": "RED"}],
                 "answers": ["Taken", "Left"],
                 "decision": {"form": "choose-option", "accepted": "Taken", "rejected": "Left", "optionsField": "offers",
                              "answerFields": {"offer": ".", "price": "price"}, "names": "entering", "autonomy": "first"}},
                {"name": "Wait", "direction": "output", "label": "Wait", "help": "Waits.", "role": "timer",
                 "fields": [{"name": "duration", "type": "duration"}]},
                {"name": "Taken", "direction": "input", "label": "Taken", "help": "Taken.",
                 "fields": [{"name": "offer", "type": "Offer"}, {"name": "price", "type": "real", "unit": "EUR"}]},
                {"name": "Left", "direction": "input", "label": "Left", "help": "Left."}
              ],
              "markups": [{"name": "Loud", "label": "Loud", "help": "Loud.", "options": [{"name": "how", "type": "Colour"}]}],
              "taskClasses": [{"name": "Dig", "help": "Dig.", "fields": [{"name": "depth", "type": "real"}]}]
            }
            """;

    private static Reading<Vocabulary> read(String words) {
        Map<String, String> files = new LinkedHashMap<>();
        files.put("domain.json", INDEX);
        files.put("words.json", words);
        return VocabularyReader.read(new VocabularyFiles(files));
    }

    @Test
    void goodDomainIsReadWhole() {
        Reading<Vocabulary> reading = read(WORDS);

        assertThat(reading.findings()).isEmpty();
        Vocabulary words = reading.orThrow();
        assertThat(words.domain()).isEqualTo("d");
        assertThat(words.event("Question")).map(EventType::name).contains("Ask");
        assertThat(words.eventWithRole(EventRole.TIMER)).map(EventType::name).contains("Wait");
        assertThat(words.types()).containsOnlyKeys("Colour", "Offer");
        assertThat(words.taskClasses()).containsOnlyKeys("Dig");
    }

    @Test
    void whichValuesAFieldCanHaveIsRead() {
        String limits = """
                {"range": [0, 6000], "usual": [1, 0.5e2], "above": "draught"}""";
        Vocabulary words = read(WORDS.replace(
                        "{\"name\": \"depth\",",
                        "{\"name\": \"draught\", \"type\": \"real\"}, {\"limits\": " + limits
                                + ", \"name\": \"depth\","))
                .orThrow();

        FieldLimits read = words.taskClasses().get("Dig").fields().get(1).limits();
        assertThat(read.range()).isEqualTo(new FieldLimits.Range(0, 6000));
        assertThat(read.usual()).isEqualTo(new FieldLimits.Range(1, 50));
        assertThat(read.above()).contains("draught");
        assertThat(read.words()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"Offer, word, E-BAD-VALUE", "Offer, price, E-BAD-VALUE", "Nothing, name, E-BAD-VALUE"})
    void namesOfRobotsStandInTextsThatThereAre(String of, String field, String code) {
        Map<String, String> files = new LinkedHashMap<>();
        files.put("domain.json", INDEX.replace("}", ", \"robotNames\": {\"" + of + "\": \"" + field + "\"}}"));
        files.put("words.json", WORDS);

        assertThat(VocabularyReader.read(new VocabularyFiles(files)).findings())
                .extracting(Finding::code, Finding::pointer)
                .containsExactly(Tuple.tuple(code, "domain.json#/robotNames/" + of));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    "name": "Left"          | "name": "Taken"         | E-DUPLICATE
                    "name": "depth"         | "limits": {"range": [2, 1]}, "name": "depth"     | E-BAD-VALUE
                    "name": "depth"         | "limits": {"range": [1]}, "name": "depth"        | E-BAD-VALUE
                    "name": "depth"         | "limits": {"words": ["deep"]}, "name": "depth"   | E-BAD-VALUE
                    "name": "depth"         | "limits": {"above": "height"}, "name": "depth"   | E-BAD-VALUE
                    "name": "depth"         | "limits": {"most": 3}, "name": "depth"           | E-UNKNOWN-MEMBER
                    "name": "how"           | "limits": {"usual": [1, 2]}, "name": "how"       | E-BAD-VALUE
                    "aliases": ["Question"] | "aliases": ["Left"]     | E-DUPLICATE
                    "record": "Offer"       | "record": "Colour"      | E-DUPLICATE
                    "record": "Offer"       | "record": "offer"       | E-BAD-VALUE
                    "RED", "GREEN"          | "RED", "RED"            | E-DUPLICATE
                    "RED", "GREEN"          | ''                      | E-MISSING-MEMBER
                    "colour": "Colour"      | "colour": "Shade"       | E-UNKNOWN-TYPE
                    "colour": "Colour"      | "colour": "list<"       | E-UNKNOWN-TYPE
                    "type": "list<Offer>"   | "type": "list<Gift>"    | E-UNKNOWN-TYPE
                    "type": "list<Offer>"   | "type": "Offer"         | E-DECISION
                    "default": "RED"        | "default": "BLUE"       | E-UNKNOWN-WORD
                    "default": "RED"        | "default": "RED", "required": true | E-BAD-VALUE
                    "answers": ["Taken", "Left"] | "answers": ["Taken", "Gone"] | E-ANSWERS
                    "answers": ["Taken", "Left"] | "answers": ["Taken", "Left", "Wait"] | E-ANSWERS
                    "answers": ["Taken", "Left"] | "answers": ["Taken"]         | E-DECISION
                    "form": "choose-option" | "form": "approve"       | E-DECISION
                    "form": "choose-option" | "form": "choose-variable" | E-DECISION
                    "form": "choose-option" | "form": "define-variables" | E-DECISION
                    "optionsField": "offers" | "optionsField": "gifts" | E-DECISION
                    "price": "price"        | "price": "colour"       | E-DECISION
                    "price": "price"        | "cost": "price"         | E-DECISION
                    "form": "choose-option" | "form": "provide"       | E-DECISION
                    "form": "choose-option" | "form": "guess"         | E-UNKNOWN-WORD
                    "form": "choose-option" | "form": "choose-option", "min": 3, "max": 2 | E-BAD-VALUE
                    "autonomy": "first"     | "autonomy": "yes"       | E-DECISION
                    "tokens": "proxy"       | "tokens": "boats"       | E-UNKNOWN-WORD
                    "flags": ["command"]    | "flags": ["loud"]       | E-UNKNOWN-WORD
                    "role": "timer"         | "role": "timer-expired" | E-BAD-VALUE
                    "name": "duration"      | "name": "time"          | E-BAD-VALUE
                    "direction": "input", "label": "Left" | "direction": "input", "answers": ["Taken"], "label": "Left" | E-ANSWERS
                    "direction": "input", "label": "Left" | "direction": "in", "label": "Left" | E-UNKNOWN-WORD
                    "help": "Left."         | "helps": "Left."        | E-UNKNOWN-MEMBER
                    "help": "Left."         | "help": ""              | E-BAD-VALUE
                    "taskClasses"           | "tasks"                 | E-UNKNOWN-MEMBER
                    "markups": [            | "markups": [3,          | E-WRONG-TYPE
                    "markups": [            | "markups": [[,          | E-SYNTAX
                    """)
    void brokenDomainIsRefused(String good, String bad, String code) {
        assertThat(WORDS).contains(good);

        Reading<Vocabulary> reading = read(WORDS.replace(good, bad));

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings()).extracting(Finding::code).contains(code);
        assertThat(reading.findings()).allMatch(f -> !f.pointer().isEmpty());
    }

    @Test
    void newerVersionIsRefused() {
        Map<String, String> files =
                Map.of("domain.json", INDEX.replace("\"formatVersion\": 1", "\"formatVersion\": 2"));

        assertThat(VocabularyReader.read(new VocabularyFiles(files)).findings())
                .extracting(Finding::code)
                .contains("E-VERSION");
    }

    @Test
    void fileThatTheIndexNamesMustBeThere(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("domain.json"), INDEX);

        assertThat(DomainLibrary.fromFolder(folder).findings())
                .extracting(Finding::code, Finding::pointer)
                .containsExactly(Tuple.tuple("E-FILE", "words.json"));
        assertThat(DomainLibrary.fromClassPath("/nowhere").findings())
                .extracting(Finding::pointer)
                .containsExactly("domain.json");
    }

    @Test
    void brokenPlanOfTheLibraryIsNamedByItsFile(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("domain.json"), INDEX.replace("}", ", \"library\": [\"p.json\"]}"));
        Files.writeString(folder.resolve("words.json"), WORDS);
        Files.writeString(folder.resolve("p.json"), "{\"formatVersion\": 1, \"id\": 7, \"domain\": \"d\"}");

        assertThat(DomainLibrary.fromFolder(folder).findings())
                .extracting(Finding::pointer)
                .containsExactly("p.json#/id");
    }

    @Test
    void domainOfTheClassPathIsLoadedOnceInAProcess() {
        assertThat(DomainLibrary.fromClassPath(CRW).orThrow())
                .isSameAs(DomainLibrary.fromClassPath(CRW).orThrow());
    }

    @Test
    void filesAsAJournalKeepsThemGiveTheSameVocabulary() {
        DomainLibrary library = DomainLibrary.fromClassPath(CRW).orThrow();

        Vocabulary again = VocabularyReader.read(
                        new VocabularyFiles(library.files().texts()))
                .orThrow();

        assertThat(again.events()).isEqualTo(library.vocabulary().events());
        assertThat(again.markups()).isEqualTo(library.vocabulary().markups());
        assertThat(library.combined().plans()).isEqualTo(library.plans());
        assertThat(library.projectOf("clv")).isPresent();
    }
}
