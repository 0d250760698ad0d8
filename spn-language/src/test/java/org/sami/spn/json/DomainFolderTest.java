package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.finding.Finding;

/** A domain's index names files of its own folder, and reads no others. */
class DomainFolderTest {
    private static final String SECRET = "{\"secret\": 1}";

    @TempDir
    private Path folder;

    private Path domain;

    @BeforeEach
    void makeFolder() throws IOException {
        domain = Files.createDirectories(folder.resolve("domain/plans"));
        domain = domain.getParent();
        Files.writeString(folder.resolve("secret.json"), SECRET);
        Files.writeString(domain.resolve("events.json"), "{}");
    }

    private List<Finding> findings(String member, String name) throws IOException {
        String named = "\"" + name.replace("\\", "\\\\") + "\"";
        String value = member.equals("files") || member.equals("library") ? "[" + named + "]" : named;
        Files.writeString(domain.resolve("domain.json"), "{\"" + member + "\": " + value + "}");
        return VocabularyFiles.fromFolder(domain).findings();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../secret.json",
                "plans/../../secret.json",
                "..\\secret.json",
                "C:\\secret.json",
                "/etc/passwd",
                ""
            })
    void fileOutsideOfTheFolderIsNamedAndNotRead(String name) throws IOException {
        assertThat(findings("files", name))
                .anySatisfy(finding ->
                        assertThat(finding.message()).contains("is outside the folder of the file that names it"));
    }

    @Test
    void symbolicLinkThatLeadsOutsideIsNotRead() throws IOException {
        Files.createSymbolicLink(domain.resolve("inside.json"), folder.resolve("secret.json"));
        Files.createSymbolicLink(domain.resolve("folder"), folder);

        assertThat(findings("files", "inside.json"))
                .anySatisfy(finding -> assertThat(finding.message()).contains("a symbolic link leads outside"));
        assertThat(findings("files", "folder/secret.json"))
                .anySatisfy(finding -> assertThat(finding.message()).contains("a symbolic link leads outside"));
    }

    @Test
    void filesOfTheFolderAreReadAlsoByLinksWithinItAndByALinkToTheFolder() throws IOException {
        Files.createSymbolicLink(domain.resolve("plans/other.json"), domain.resolve("events.json"));
        assertThat(findings("files", "events.json")).isEmpty();
        assertThat(findings("files", "plans/other.json")).isEmpty();

        Path link = Files.createSymbolicLink(folder.resolve("link"), domain);
        assertThat(VocabularyFiles.fromFolder(link).orThrow().texts()).containsKey("plans/other.json");
    }
}
