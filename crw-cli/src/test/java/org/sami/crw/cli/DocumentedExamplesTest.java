package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The examples of the documents do as they are printed what the documents say. */
class DocumentedExamplesTest {
    private static final Path DOCS = Path.of("../docs");
    private static final Pattern JSON_BLOCK = Pattern.compile("```json\n(.*?)```", Pattern.DOTALL);
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    @Test
    void projectOfTheFileFormatIsFreeOfFindingsRunsAndIsDrawn() throws Exception {
        String project = example("file-format.md");

        CommandResult check = CommandResult.crw("check", project);
        CommandResult run = CommandResult.crw("run", project, "--speed", "max", "--json");

        assertThat(check.out()).isEqualTo(project + ": 0 errors, 0 warnings\n");
        assertThat(run.exitCode()).as(run.err()).isZero();
        assertThat(JSON.readTree(run.out()).get("outcome").asText()).isEqualTo("ended");
        assertThat(CommandResult.crw(
                                "draw",
                                project,
                                "--svg",
                                folder.resolve("net.svg").toString())
                        .exitCode())
                .isZero();
    }

    @Test
    void answersOfTheAnswersFileAreGivenAsTheySay() throws Exception {
        String answers = example("answers-file.md");

        CommandResult run = CommandResult.crw("run", "clv", "--answers", answers, "--speed", "max", "--json");

        assertThat(run.exitCode()).as(run.err() + run.out()).isZero();
        JsonNode report = JSON.readTree(run.out());
        List<String> asked = report.get("decisions").findValuesAsText("type");
        assertThat(report.get("locationsVisited").asInt()).isEqualTo(2);
        assertThat(asked.stream().filter("OperatorAllocationOptions"::equals)).hasSize(2);
        assertThat(report.get("boats").findValuesAsText("distanceM"))
                .filteredOn(distance -> Double.parseDouble(distance) == 0)
                .hasSize(1);
    }

    /** The only JSON block of a page, as a file. */
    private String example(String page) throws IOException {
        List<String> blocks = JSON_BLOCK
                .matcher(Files.readString(DOCS.resolve(page)))
                .results()
                .map((MatchResult block) -> block.group(1))
                .toList();
        assertThat(blocks).hasSize(1);
        return Files.writeString(folder.resolve("example.json"), blocks.get(0)).toString();
    }
}
