package org.sami.lessons.script;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;

/** Edits of a plan as data: what a step of a lesson shows, and how a solution is made from its start. */
public record EditScript(List<ScriptElement> elements) {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();

    public EditScript {
        elements = List.copyOf(elements);
    }

    /**
     * Reads the elements of a script that stands in another document.
     *
     * @param pointer of the list of elements in its document; pointers of findings begin with it
     */
    public static Reading<EditScript> read(List<JsonNode> elements, String pointer) {
        ScriptProblems problems = new ScriptProblems();
        List<ScriptElement> read = new ArrayList<>();
        for (int i = 0; i < elements.size(); i++) {
            JsonObjectReader.of(elements.get(i), pointer + "/" + i, problems)
                    .flatMap(ScriptReader::read)
                    .ifPresent(read::add);
        }
        return new Reading<>(problems.none() ? Optional.of(new EditScript(read)) : Optional.empty(), problems.list());
    }

    /**
     * Reads a script from a file's text: a list of elements, or an object with such a list as its {@code script}.
     *
     * @param file its path, for findings
     */
    public static Reading<EditScript> read(String file, String text) {
        JsonNode root;
        try {
            root = MAPPER.readTree(text);
        } catch (JsonProcessingException e) {
            return new Reading<>(Optional.empty(), List.of(syntax(file, e)));
        }
        String pointer = root.isObject() ? "/script" : "";
        JsonNode list = root.isObject() ? root.path("script") : root;
        if (!list.isArray()) {
            Finding finding = Finding.error(
                    "E-WRONG-TYPE", list.isMissingNode() ? "" : pointer, "A script is a list of elements");
            return new Reading<EditScript>(Optional.empty(), List.of(finding)).locatedIn(file, text);
        }
        List<JsonNode> elements = new ArrayList<>();
        list.forEach(elements::add);
        return read(elements, pointer).locatedIn(file, text);
    }

    private static Finding syntax(String file, JsonProcessingException e) {
        String message = e.getOriginalMessage();
        Finding finding = Finding.error(
                "E-SYNTAX",
                "",
                message == null ? "not JSON" : message.lines().findFirst().orElse("not JSON"));
        JsonLocation at = e.getLocation();
        return at == null || at.getLineNr() < 1 || at.getColumnNr() < 1
                ? finding
                : finding.at(new SourceLocation(file, at.getLineNr(), at.getColumnNr()));
    }

    /** Makes the edits in a project, whose first plan is open, up to the first that is refused. */
    public ScriptRun applyTo(Project project, DomainLibrary domain) {
        return applyTo(project, domain.vocabulary(), domain.authoring());
    }

    /**
     * Makes the edits in a project, whose first plan is open, up to the first that is refused.
     *
     * @param vocabulary the words that are known, of a lesson those that were introduced
     */
    public ScriptRun applyTo(Project project, Vocabulary vocabulary, AuthoringLibrary library) {
        return ScriptRun.of(elements, project, vocabulary, library);
    }
}
