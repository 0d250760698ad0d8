package org.sami.architecture;

import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What keeps the build working on both kinds of machines (docs/decisions/0001). */
class BuildHouseTest {
    @Test
    void wrapperSeesToItsDistributionFirst() throws IOException {
        String gradlew = Files.readString(Path.of("gradlew"));

        assertThat(gradlew).contains("\"$APP_HOME/tools/ensure-gradle.sh\" \"$JAVACMD\" \"$CLASSPATH\" || exit");
    }

    @Test
    void everyScriptMeansTheSameGradle() throws IOException {
        String properties = Files.readString(Path.of("gradle", "wrapper", "gradle-wrapper.properties"));
        Matcher distribution =
                Pattern.compile("gradle-(\\d+\\.\\d+(?:\\.\\d+)?)-bin").matcher(properties);

        assertThat(distribution.find()).isTrue();
        String version = distribution.group(1);
        assertThat(Files.readString(Path.of("tools", "ensure-gradle.sh"))).contains("gradle-" + version + "-bin");
        assertThat(Files.readString(Path.of("tools", "bootstrap-gradle.sh"))).contains("V=" + version + "\n");
    }

    @Test
    void buildFilesNameNoRepositoryButMavenCentral() throws IOException {
        List<Path> files = buildFiles();

        assertThat(files).hasSizeGreaterThanOrEqualTo(SamiModule.values().length + 4);
        for (Path file : files) {
            assertThat(Files.readString(file))
                    .as(file.toString())
                    .doesNotContain("gradlePluginPortal", "jcenter", "google()", "mavenLocal", "url ", "url=");
        }
    }

    private static List<Path> buildFiles() throws IOException {
        try (Stream<Path> all = Files.walk(Path.of(""), 5)) {
            return all.filter(Files::isRegularFile)
                    .filter(path -> path.toString().endsWith(".gradle"))
                    .filter(path -> !path.toString().contains("build/"))
                    .sorted()
                    .collect(toList());
        }
    }
}
