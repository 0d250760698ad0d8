package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.Schema;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.Stream;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** The project format: what is read, what is refused with which finding, and that the published schema agrees. */
class ProjectFormatTest {
    private static final Vocabulary WORDS =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Path EVERYTHING = Path.of("src/test/resources/everything.json");

    private final ProjectReader reader = new ProjectReader(WORDS);
    private final ProjectWriter writer = new ProjectWriter(WORDS);

    @Test
    void fileWithOneOfEverythingIsWrittenBackByteForByte() throws IOException {
        Reading<Project> reading = reader.read(EVERYTHING);

        assertThat(reading.findings()).isEmpty();
        assertThat(writer.text(reading.orThrow())).isEqualTo(Files.readString(EVERYTHING));
    }

    @Test
    void folderHoldsTheSameProjectAsTheDocument(@TempDir Path folder) throws IOException {
        Project project = reader.read(EVERYTHING).orThrow();

        writer.write(project, folder);

        assertThat(reader.read(folder).orThrow()).isEqualTo(project);
        assertThat(folder.resolve("plans/child.json")).exists();
    }

    @Test
    void findingInAPlanFileNamesThatFile(@TempDir Path folder) throws IOException {
        writer.write(reader.read(EVERYTHING).orThrow(), folder);
        Path child = folder.resolve("plans/child.json");
        Files.writeString(
                child, Files.readString(child).replace("\"t1\"", "\"t9\"").replaceFirst("\"t9\"", "\"t1\""));

        Reading<Project> reading = reader.read(folder);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(Tuple.tuple("E-DANGLING", "plans/child.json#/inEdges/0/transition"));
    }

    @Test
    void schemaThatAFileNamesIsKept() throws IOException {
        String text =
                Files.readString(EVERYTHING).replaceFirst("\\{", "{\n  \"\\$schema\": \"project-1.schema.json\",");

        Project project = reader.read(text).orThrow();

        assertThat(writer.text(project)).isEqualTo(text);
    }

    @Test
    void schemaThatAPlanFileNamesIsKept(@TempDir Path folder) throws IOException {
        writer.write(reader.read(EVERYTHING).orThrow(), folder);
        Path child = folder.resolve("plans/child.json");
        String text = Files.readString(child)
                .replaceFirst("\\{", "{\n  \"\\$schema\": \"../project-1.schema.json#/\\$defs/plan\",");
        Files.writeString(child, text);

        Project project = reader.read(folder).orThrow();
        writer.write(project, folder);

        assertThat(child).hasContent(text);
    }

    @Test
    void everyFindingOfAFileHasItsPlaceAndElement(@TempDir Path folder) throws IOException {
        JsonNode root = tree();
        edit(root, "/plans/0/places/0/outputs/0/type", "\"Dance\"");
        edit(root, "/plans/0/inEdges/0/place", "\"nowhere\"");
        Path file = Files.writeString(folder.resolve("p.json"), root.toPrettyString());

        Reading<Project> reading = reader.read(file);

        assertThat(reading.findings()).hasSizeGreaterThanOrEqualTo(2).allSatisfy(finding -> {
            assertThat(finding.elements()).isNotEmpty();
            SourceLocation at = finding.location().orElseThrow();
            assertThat(at.file()).isEqualTo(file.toString());
            String value = Files.readAllLines(file).get(at.line() - 1).substring(at.column() - 1);
            JsonNode meant = root.at(finding.pointer());
            assertThat(value).startsWith(meant.isContainerNode() ? meant.isArray() ? "[" : "{" : meant.toString());
        });
    }

    @Test
    void writingReplacesTheFileAndLeavesNothingElse(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("p.json"), "old");

        writer.write(reader.read(EVERYTHING).orThrow(), file);

        assertThat(file).hasSameTextualContentAs(EVERYTHING);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void writingKeepsTheFilesPermissionsAndFollowsLinks(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("p.json"), "old");
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        assumeThat(view).as("a file system with permissions").isNotNull();
        view.setPermissions(PosixFilePermissions.fromString("rw-rw-r--"));
        Path link = Files.createSymbolicLink(folder.resolve("link.json"), file);

        writer.write(reader.read(EVERYTHING).orThrow(), link);

        assertThat(link).isSymbolicLink();
        assertThat(file).hasSameTextualContentAs(EVERYTHING);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-rw-r--");
    }

    @Test
    void aliasesAreReadAsTheNamesThatTheyStandFor() throws IOException {
        String text = Files.readString(EVERYTHING)
                .replace("\"OperatorSelectBoatList\"", "\"OperatorSelectRobotList\"")
                .replace("\"MixedInitiativeTrigger\"", "\"MixedInitiative\"");

        assertThat(reader.read(text).orThrow())
                .isEqualTo(reader.read(EVERYTHING).orThrow());
    }

    @Test
    void newerVersionIsRefusedByItselfAndClearly() throws IOException {
        String text =
                Files.readString(EVERYTHING).replace("\"formatVersion\": 1", "\"formatVersion\": 2, \"colour\": 3");

        Reading<Project> reading = reader.read(text);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .usingRecursiveFieldByFieldElementComparatorIgnoringFields("location")
                .containsExactly(Finding.error(
                        "E-VERSION",
                        "/formatVersion",
                        "This file was written by a newer program (format version 2); this program reads version 1"));
    }

    @Test
    void textThatIsNotJsonIsRefusedWithLineAndColumn() {
        Reading<Project> reading = reader.read("{\n  \"formatVersion\": 1,\n  \"id\" \"x\"\n}");

        assertThat(reading.findings()).hasSize(1);
        assertThat(reading.findings().get(0).code()).isEqualTo("E-SYNTAX");
        assertThat(reading.findings().get(0).location()).contains(new SourceLocation("", 3, 8));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "[]", "1", "null", "{}", "{\"id\":1,\"id\":2}", "{} {}", "\u0000", "[[[[[["})
    void otherTextIsRefusedWithoutAnException(String text) {
        Reading<Project> reading = reader.read(text);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.hasErrors()).isTrue();
    }

    @Test
    void fileThatIsAbsentOrNoTextIsAFinding(@TempDir Path folder) throws IOException {
        Path binary = Files.write(folder.resolve("b.json"), new byte[] {(byte) 0xff, (byte) 0xfe, 0});

        assertThat(reader.read(folder.resolve("no.json")).findings())
                .extracting(Finding::code)
                .containsExactly("E-FILE");
        assertThat(reader.read(folder).findings()).extracting(Finding::code).containsExactly("E-FILE");
        assertThat(reader.read(binary).findings()).extracting(Finding::code).containsExactly("E-FILE");
    }

    @Test
    void everyProblemIsReportedAtOnce() throws IOException {
        JsonNode root = tree();
        edit(root, "/plans/0/places/0/outputs/0/type", "\"Dance\"");
        edit(root, "/plans/0/inEdges/0/place", "\"nowhere\"");
        edit(root, "/plans/1/transitions/0/id", "\"p1\"");
        edit(root, "/globals/0/initial", "\"soon\"");

        Reading<Project> reading = reader.read(root.toString());

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code)
                .contains("E-UNKNOWN-EVENT", "E-DANGLING", "E-DUPLICATE", "E-BAD-VALUE");
    }

    @Test
    void oneProblemIsOneFinding() throws IOException {
        JsonNode root = tree();
        edit(root, "/plans/1/id", "5");
        edit(root, "/missionTree/0/children/1/children/0/plan", "\"main\"");
        edit(root, "/plans/0/places/2/subMissions", "[]");

        assertThat(reader.read(root.toString()).findings())
                .usingRecursiveFieldByFieldElementComparatorIgnoringFields("location")
                .containsExactly(Finding.error("E-WRONG-TYPE", "/plans/1/id", "Text is expected here, not 5"));
    }

    @Test
    void planThatMakesNoSenseIsReadButNotWithoutAnError() throws IOException {
        JsonNode root = tree();
        edit(root, "/plans/0/places/1/start", "true");

        Reading<Project> reading = reader.readAndCheck(root.toString());

        assertThat(reading.result()).isPresent();
        assertThat(reading.hasErrors()).isTrue();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(Tuple.tuple("E-TWO-STARTS", "/plans/0/places/1"));
    }

    @Test
    void secondStartIsToldTogetherWithWhatKeepsTheDocumentFromBeingLoaded() throws IOException {
        JsonNode root = tree();
        edit(root, "/plans/0/places/1/start", "true");
        edit(root, "/plans/0/inEdges/0/place", "\"nowhere\"");

        Reading<Project> reading = reader.readAndCheck(root.toString());

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(
                        Tuple.tuple("E-TWO-STARTS", "/plans/0/places/1"),
                        Tuple.tuple("E-DANGLING", "/plans/0/inEdges/0/place"));
    }

    /** The last column says whether the schema alone, without vocabulary and references, refuses the document too. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        /id                                               | REMOVE                | E-MISSING-MEMBER | ''                                    | yes
        /id                                               | ""                    | E-BAD-VALUE      | /id                                   | yes
        /name                                             | 5                     | E-WRONG-TYPE     | /name                                 | yes
        /colour                                           | "red"                 | E-UNKNOWN-MEMBER | /colour                               | yes
        /formatVersion                                    | 0                     | E-VERSION        | /formatVersion                        | yes
        /formatVersion                                    | "1"                   | E-VERSION        | /formatVersion                        | yes
        /formatVersion                                    | REMOVE                | E-VERSION        | ''                                    | yes
        /domain                                           | "planes"              | E-DOMAIN         | /domain                               | no
        /globals/0/name                                   | "shared"              | E-VARIABLE-NAME  | /globals/0/name                       | yes
        /globals/0/name                                   | "@task"               | E-VARIABLE-NAME  | /globals/0/name                       | yes
        /globals/0/name                                   | "@areas"              | E-DUPLICATE      | /globals/1/name                       | no
        /globals/0/type                                   | "Time"                | E-UNKNOWN-TYPE   | /globals/0/type                       | no
        /globals/0/type                                   | "time"                | E-UNKNOWN-TYPE   | /globals/0/type                       | no
        /globals/0/initial                                | 7200                  | E-WRONG-TYPE     | /globals/0/initial                    | no
        /missionTree/0/children/0/plan                    | "none"                | E-UNKNOWN-PLAN   | /missionTree/0/children/0/plan        | no
        /plans/1/id                                       | "main"                | E-DUPLICATE      | /plans/1/id                           | no
        /plans/1                                          | {"file":"../x.json"}  | E-FILE           | /plans/1/file                         | no
        /plans/1                                          | {"file":"x.json"}     | E-FILE           | x.json                                | no
        /plans/1                                          | 3                     | E-WRONG-TYPE     | /plans/1                              | yes
        /plans/0/reads/0                                  | "x"                   | E-VARIABLE-NAME  | /plans/0/reads                        | yes
        /plans/0/tasks/0/class                            | "Dive"                | E-UNKNOWN-TASK   | /plans/0/tasks/0/class                | no
        /plans/0/tasks/0/fields/depth                     | 1                     | E-UNKNOWN-FIELD  | /plans/0/tasks/0/fields/depth         | no
        /plans/0/tasks/1/name                             | "T1"                  | E-DUPLICATE      | /plans/0/tasks/1/name                 | no
        /plans/0/places/1/id                              | "t1"                  | E-DUPLICATE      | /plans/0/transitions/0/id             | no
        /plans/0/places/0/start                           | "yes"                 | E-WRONG-TYPE     | /plans/0/places/0/start               | yes
        /plans/0/places/0/disabled                        | "yes"                 | E-WRONG-TYPE     | /plans/0/places/0/disabled            | yes
        /plans/0/transitions/0/disabled                   | 1                     | E-WRONG-TYPE     | /plans/0/transitions/0/disabled       | yes
        /plans/0/frames/0/color                           | "red"                 | E-UNKNOWN-WORD   | /plans/0/frames/0/color               | yes
        /plans/0/frames/0/at                              | [1]                   | E-WRONG-TYPE     | /plans/0/frames/0/at                  | yes
        /plans/0/frames/0/size                            | [0, 3]                | E-BAD-VALUE      | /plans/0/frames/0/size                | yes
        /plans/0/frames/0                                 | {"at": [0, 0]}        | E-MISSING-MEMBER | /plans/0/frames/0/size                | yes
        /plans/0/queries/0/text                           | REMOVE                | E-MISSING-MEMBER | /plans/0/queries/0                    | yes
        /plans/0/queries/1/name                           | "somebody waits"      | E-DUPLICATE      | /plans/0/queries/1/name               | no
        /plans/0/queries/1/expect                         | "perhaps"             | E-UNKNOWN-WORD   | /plans/0/queries/1/expect             | yes
        /plans/0/places/1/mode                            | "Recovery"            | E-UNKNOWN-WORD   | /plans/0/places/1/mode                | yes
        /plans/0/places/0/transitionOrder/0               | "t9"                  | E-DANGLING       | /plans/0/places                       | no
        /plans/0/places/0/outputs/0/type                  | "OperatorSelectBoats" | E-UNKNOWN-EVENT  | /plans/0/places/0/outputs/0/type      | no
        /plans/0/places/0/outputs/0/type                  | "YesOption"           | E-EVENT-SIDE     | /plans/0/places/0/outputs/0/type      | no
        /plans/0/places/0/outputs/0/id                    | "p1"                  | E-DUPLICATE      | /plans/0/places/0/outputs/0/id        | no
        /plans/0/places/1/outputs/0/fields/depth          | {"value":1}           | E-UNKNOWN-FIELD  | /plans/0/places/1/outputs/0/fields/depth | no
        /plans/0/places/1/outputs/0/fields/spacing        | {"value":"far"}       | E-WRONG-TYPE     | /plans/0/places/1/outputs/0/fields/spacing/value | no
        /plans/0/places/1/outputs/0/fields/spacing        | {"value":1,"ask":"editable"} | E-MISSING-MEMBER | /plans/0/places/1/outputs/0/fields/spacing | yes
        /plans/0/places/1/outputs/0/fields/spacing        | {"ask":"locked"}      | E-MISSING-MEMBER | /plans/0/places/1/outputs/0/fields/spacing | yes
        /plans/0/places/1/outputs/0/fields/spacing        | {"ask":"sometimes"}   | E-UNKNOWN-WORD   | /plans/0/places/1/outputs/0/fields/spacing/ask | yes
        /plans/0/places/1/outputs/0/fields/spacing        | 3                     | E-WRONG-TYPE     | /plans/0/places/1/outputs/0/fields/spacing | yes
        /plans/0/places/1/outputs/0/fields/spacing        | {"variable":"x"}      | E-VARIABLE-NAME  | /plans/0/places/1/outputs/0/fields/spacing/variable | yes
        /plans/0/places/1/outputs/0/writes/depth          | "@x"                  | E-UNKNOWN-FIELD  | /plans/0/places/1/outputs/0/writes/depth | no
        /plans/0/places/1/outputs/0/writes/spacing        | "@task"               | E-VARIABLE-NAME  | /plans/0/places/1/outputs/0/writes/spacing | yes
        /plans/0/places/0/outputs/0/markups/0/type        | "Shiny"               | E-UNKNOWN-MARKUP | /plans/0/places/0/outputs/0/markups/0/type | no
        /plans/0/places/0/outputs/0/markups/0/options/colour | 1                  | E-UNKNOWN-OPTION | /plans/0/places/0/outputs/0/markups/0/options/colour | no
        /plans/0/places/0/outputs/0/markups/0/options/trigger | "LATER"           | E-UNKNOWN-WORD   | /plans/0/places/0/outputs/0/markups/0/options/trigger | no
        /plans/0/places/0/outputs/0/markups/0/options/trigger | REMOVE            | E-MISSING-MEMBER | /plans/0/places/0/outputs/0/markups/0 | no
        /plans/0/places/2/subMissions/0/plan              | "none"                | E-UNKNOWN-PLAN   | /plans/0/places/2/subMissions/0/plan  | no
        /plans/0/places/2/subMissions/0/variables/x       | "@y"                  | E-VARIABLE-NAME  | /plans/0/places/2/subMissions/0/variables/x | yes
        /plans/0/transitions/0/waitFor                    | "some"                | E-UNKNOWN-WORD   | /plans/0/transitions/0/waitFor        | yes
        /plans/0/transitions/1/inputs/0/fields/interruptName | 1                  | E-WRONG-TYPE     | /plans/0/transitions/1/inputs/0/fields/interruptName | no
        /plans/0/transitions/0/inputs/0/type              | "StartTimer"          | E-EVENT-SIDE     | /plans/0/transitions/0/inputs/0/type  | no
        /plans/0/inEdges/0/place                          | "p9"                  | E-DANGLING       | /plans/0/inEdges/0/place              | no
        /plans/0/inEdges/0/transition                     | "p2"                  | E-DANGLING       | /plans/0/inEdges/0/transition         | no
        /plans/0/outEdges/0/place                         | REMOVE                | E-MISSING-MEMBER | /plans/0/outEdges/0                   | yes
        /plans/0/inEdges/1/transition                     | "t1"                  | E-DUPLICATE      | /plans/0/inEdges/1                    | no
        /plans/0/inEdges/0/requirements/0/match           | REMOVE                | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/0/requirements/0/n               | 0                     | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/0/requirements/0/n               | REMOVE                | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/0/requirements/0/match           | "all"                 | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/0/requirements/0/kind            | "sub-mission-tokens"  | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/0/requirements/0/task            | "T1"                  | E-REQUIREMENT    | /plans/0/inEdges/0/requirements/0     | yes
        /plans/0/inEdges/1/requirements/0/n               | 1                     | E-REQUIREMENT    | /plans/0/inEdges/1/requirements/0     | yes
        /plans/0/inEdges/3/requirements/1/task            | REMOVE                | E-REQUIREMENT    | /plans/0/inEdges/3/requirements/1     | yes
        /plans/0/outEdges/0/requirements/0/n              | 0                     | E-REQUIREMENT    | /plans/0/outEdges/0/requirements/0    | yes
        /plans/0/outEdges/0/requirements/1/n              | "many"                | E-REQUIREMENT    | /plans/0/outEdges/0/requirements/1    | yes
        /plans/0/outEdges/2/requirements/0/n              | REMOVE                | E-REQUIREMENT    | /plans/0/outEdges/2/requirements/0    | yes
        /plans/0/outEdges/0/requirements/1/action         | REMOVE                | E-REQUIREMENT    | /plans/0/outEdges/0/requirements/1    | yes
        /plans/0/layout/p9                                | [1,2]                 | E-DANGLING       | /plans/0/layout/p9                    | no
        /plans/0/layout/p1                                | [1]                   | E-WRONG-TYPE     | /plans/0/layout/p1                    | yes
        /plans/0/notes/0                                  | 1                     | E-WRONG-TYPE     | /plans/0/notes/0                      | yes
        /plans/0/testCases/0/steps/0/do                   | "dance"               | E-UNKNOWN-WORD   | /plans/0/testCases/0/steps/0          | yes
        /plans/0/testCases/0/steps/0/values/e9.x          | 1                     | E-UNKNOWN-FIELD  | /plans/0/testCases/0/steps/0/values/e9.x | no
        /plans/0/testCases/0/steps/1/event                | "e9"                  | E-DANGLING       | /plans/0/testCases/0/steps/1/event    | no
        /plans/0/testCases/0/steps/4/rejected             | false                 | E-BAD-VALUE      | /plans/0/testCases/0/steps/4/rejected | yes
        /plans/0/testCases/0/steps/5/type                 | "Nothing"             | E-UNKNOWN-EVENT  | /plans/0/testCases/0/steps/5/type     | no
        /plans/0/testCases/0/steps/10/by                  | REMOVE                | E-MISSING-MEMBER | /plans/0/testCases/0/steps/10         | yes
        /plans/0/testCases/0/steps/11/generic              | -1                    | E-BAD-VALUE      | /plans/0/testCases/0/steps/11/generic  | yes
        """)
    void brokenDocumentIsRefused(String at, String value, String code, String pointer, String schemaToo)
            throws IOException {
        JsonNode root = tree();
        edit(root, at, value);

        Reading<Project> reading = reader.read(root.toString());

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(Tuple.tuple(code, pointer));
        Schema schema = Schemas.load("project-1.schema.json");
        assertThat(Schemas.errors(schema, root).isEmpty())
                .as("accepted by the schema")
                .isEqualTo(schemaToo.equals("no"));
    }

    @ParameterizedTest
    @CsvSource({
        "take, 2, relevant",
        "consume, 1, relevant",
        "add, 3, relevant",
        "add, all, relevant",
        "add, all, generic"
    })
    void everyQuantityOfAnOutRequirementIsReadAndWrittenBack(String action, String n, String kind) throws IOException {
        String quantity = n.equals("all") ? "\"all\"" : n;
        String requirement = "{\"action\": \"" + action + "\", \"n\": " + quantity + ", \"kind\": \"" + kind + "\"}";
        String text = Files.readString(EVERYTHING)
                .replace("{\"action\": \"take\", \"n\": \"all\", \"kind\": \"relevant\"}", requirement);

        assertThat(writer.text(reader.read(text).orThrow())).isEqualTo(text).contains(requirement);
        assertThat(Schemas.errors(Schemas.load("project-1.schema.json"), Schemas.MAPPER.readTree(text)))
                .isEmpty();
    }

    @Test
    void schemaAcceptsWhatTheReaderAccepts() throws IOException {
        Schema schema = Schemas.load("project-1.schema.json");

        assertThat(Schemas.errors(schema, tree())).isEmpty();
    }

    private static JsonNode tree() throws IOException {
        return Schemas.MAPPER.readTree(Files.readString(EVERYTHING));
    }

    /** Sets or removes what stands at a pointer. */
    private static void edit(JsonNode root, String at, String value) throws IOException {
        JsonPointer pointer = JsonPointer.compile(at);
        JsonNode parent = root.at(pointer.head());
        String last = pointer.last().getMatchingProperty();
        boolean remove = value.equals("REMOVE");
        assertThat(parent.isContainerNode())
                .as("something stands at %s", pointer.head())
                .isTrue();
        if (parent instanceof ArrayNode array) {
            array.set(Integer.parseInt(last), Schemas.MAPPER.readTree(value));
        } else if (remove) {
            assertThat(((ObjectNode) parent).remove(last)).as("%s", at).isNotNull();
        } else {
            ((ObjectNode) parent).set(last, Schemas.MAPPER.readTree(value));
        }
    }
}
