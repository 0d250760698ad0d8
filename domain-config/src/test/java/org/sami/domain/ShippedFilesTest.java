package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.networknt.schema.Schema;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.json.CanonicalJson;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;

class ShippedFilesTest {
    private static final String CRW = "/org/sami/domain/crw";
    private static final String UAV = "/org/sami/domain/uav";
    private static final Path RESOURCES = Path.of("src/main/resources");
    private static final Path TEST_RESOURCES = Path.of("src/test/resources");
    private static final int LEAST_FILES = 9;

    private static List<Path> jsonFiles() throws IOException {
        try (Stream<Path> main = Files.walk(RESOURCES);
                Stream<Path> test = Files.walk(TEST_RESOURCES)) {
            return Stream.concat(main, test)
                    .filter(f -> f.toString().endsWith(".json"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void boatsDomainIsReadWithoutAnyFinding() {
        Reading<DomainLibrary> reading = DomainLibrary.fromClassPath(CRW);

        assertThat(reading.findings()).isEmpty();
        assertThat(reading.orThrow().plans())
                .extracting(Plan::id)
                .startsWith("clv", "station-keep", "clv-interrupts", "assemble", "recharge", "measure", "explore-area")
                .contains("explore-team", "connect-boat", "resend-waypoints")
                .doesNotHaveDuplicates();
        assertThat(reading.orThrow().vocabulary().markups()).hasSize(19);
    }

    @ParameterizedTest
    @ValueSource(strings = {CRW, UAV})
    void folderAndClassPathHoldTheSameDomain(String domain) {
        DomainLibrary fromFolder =
                DomainLibrary.fromFolder(RESOURCES.resolve(domain.substring(1))).orThrow();

        DomainLibrary fromClassPath = DomainLibrary.fromClassPath(domain).orThrow();
        assertThat(fromFolder.projects()).isEqualTo(fromClassPath.projects());
        assertThat(fromFolder.files()).isEqualTo(fromClassPath.files());
    }

    @ParameterizedTest
    @ValueSource(strings = {CRW, UAV})
    void everyShippedPlanPassesAllChecks(String domain) {
        DomainLibrary library = DomainLibrary.fromClassPath(domain).orThrow();

        assertThat(library.projects()).isNotEmpty();
        library.projects()
                .values()
                .forEach(project -> assertThat(PlanChecks.check(project, library.vocabulary()))
                        .isEmpty());
    }

    @Test
    void everyShippedFileIsValidByItsSchema() throws IOException {
        for (Path file : jsonFiles()) {
            String path = file.toString().replace('\\', '/');
            if (!path.contains("/schemas/")) {
                boolean project =
                        Stream.of("/plans/", "/deployments/", "everything").anyMatch(path::contains);
                String of = path.endsWith("/legacy.json") ? "legacy-classes" : project ? "project" : "vocabulary";
                of = path.endsWith("/components.json") ? "components" : of;
                of = path.endsWith("/authoring.json") ? "authoring" : of;
                Schema schema = Schemas.load(of + "-1.schema.json");

                assertThat(Schemas.errors(schema, Schemas.MAPPER.readTree(Files.readString(file))))
                        .as(path)
                        .isEmpty();
            }
        }
    }

    /** With {@code -PcanonicalWrite} the files are put into that form instead. */
    @Test
    void everyFileIsLaidOutCanonically() throws IOException {
        List<Path> files = jsonFiles();
        assertThat(files).hasSizeGreaterThanOrEqualTo(LEAST_FILES);
        for (Path file : files) {
            String text = Files.readString(file);
            String canonical = CanonicalJson.format(text).orThrow();

            if (Boolean.getBoolean("canonical.write")) {
                Files.writeString(file, canonical);
            } else {
                assertThat(text).as("%s", file).isEqualTo(canonical);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {CRW, UAV})
    void everyPlanFileIsWrittenBackByteForByte(String domain) throws IOException {
        DomainLibrary library = DomainLibrary.fromClassPath(domain).orThrow();
        ProjectWriter writer = new ProjectWriter(library.vocabulary());
        Path folder = RESOURCES.resolve(domain.substring(1));

        assertThat(library.projects()).isNotEmpty();
        library.projects()
                .forEach((name, project) -> assertThat(folder.resolve(name)).hasContent(writer.text(project)));
    }
}
