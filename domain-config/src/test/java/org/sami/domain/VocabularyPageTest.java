package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;

class VocabularyPageTest {
    private static final Path PAGE = Path.of("../docs/vocabulary.md");

    /** With {@code -PcanonicalWrite} the page is written instead. */
    @Test
    void theReferencePageSaysWhatTheVocabularyDeclares() throws IOException {
        String page = VocabularyPage.of(
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow().vocabulary());

        if (Boolean.getBoolean("canonical.write")) {
            Files.writeString(PAGE, page);
        } else {
            assertThat(PAGE)
                    .as("put it right with ./gradlew :domain-config:test -PcanonicalWrite")
                    .hasContent(page);
        }
    }
}
