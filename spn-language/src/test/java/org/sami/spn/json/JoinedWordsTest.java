package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.NamedType;
import org.sami.spn.vocabulary.Vocabulary;

/** A domain that combines others has the words of all, and says what holds where they differ. */
class JoinedWordsTest {
    private static final String LAND = "{\"types\": [{\"enum\": \"Colour\", \"constants\": [\"RED\"]}, {\"enum\":"
            + " \"Size\", \"constants\": [\"S\", \"L\"]}], \"taskClasses\": [{\"name\": \"Dig\", \"help\": \"Digs.\"}]}";
    private static final String SEA = "{\"types\": [{\"enum\": \"Colour\", \"constants\": [\"BLUE\"]}, {\"enum\":"
            + " \"Size\", \"constants\": [\"S\", \"L\"]}], \"taskClasses\": [{\"name\": \"Dive\", \"help\": \"Dives.\"}]}";

    @TempDir
    private Path folder;

    private Path domain(String name, String combines, String words) throws IOException {
        Path domain = Files.createDirectories(folder.resolve(name));
        Files.writeString(
                domain.resolve("domain.json"),
                "{\"formatVersion\": 1, \"domain\": \"" + name + "\", \"label\": \"x\", " + combines
                        + "\"files\": [\"words.json\"], \"library\": []}");
        Files.writeString(domain.resolve("words.json"), words);
        return domain;
    }

    private Reading<DomainLibrary> both(String own) throws IOException {
        domain("land", "", LAND);
        domain("sea", "", SEA);
        return DomainLibrary.fromFolder(domain("both", "\"combines\": [\"land\", \"sea\"], ", own));
    }

    @Test
    void ownFilesSayWhatHoldsWhereTwoDiffer() throws IOException {
        Vocabulary words = both("{\"types\": [{\"enum\": \"Colour\", \"constants\": [\"RED\", \"BLUE\"]}]}")
                .orThrow()
                .vocabulary();

        assertThat(words.domain()).isEqualTo("both");
        assertThat(words.combines()).containsExactly("land", "sea");
        assertThat(words.types()).containsOnlyKeys("Colour", "Size");
        assertThat(((NamedType.Enumeration) words.types().get("Colour")).constants())
                .containsExactly("RED", "BLUE");
        assertThat(words.taskClasses()).containsOnlyKeys("Dig", "Dive");
    }

    @Test
    void differenceThatIsNotSettledNamesBothFiles() throws IOException {
        List<Finding> findings = both("{}").findings();

        assertThat(findings).hasSize(1);
        assertThat(findings.get(0).message())
                .contains("\"Colour\"", "land/words.json", "sea/words.json", "define it under \"types\"");
    }

    @Test
    void domainThatIsNotThereIsNamed() throws IOException {
        List<Finding> findings = VocabularyFiles.fromFolder(domain("both", "\"combines\": [\"moon\"], ", "{}"))
                .findings();

        assertThat(findings).extracting(Finding::message).containsExactly("The file moon/domain.json is not there");
    }

    @Test
    void domainThatCombinesOthersItselfIsRefused() throws IOException {
        both("{\"types\": [{\"enum\": \"Colour\", \"constants\": [\"RED\"]}]}");
        List<Finding> findings = VocabularyFiles.fromFolder(domain("all", "\"combines\": [\"both\"], ", "{}"))
                .findings();

        assertThat(findings).extracting(Finding::message).anyMatch(text -> text.contains("combines others itself"));
    }
}
