package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Which packages NullAway checks (docs/decisions/0440). */
class NullMarkedTest {
    @Test
    void everyPackageIsChecked() throws IOException {
        Set<String> unmarked = new TreeSet<>();
        for (Path source : sources()) {
            if (source.endsWith("package-info.java")
                    && !Files.readString(source).contains("\n@NullMarked\npackage ")) {
                unmarked.add(name(source.getParent()));
            }
        }
        unmarked.removeIf(name -> name.startsWith("org.sami.boat")); // by an option of the compiler

        assertThat(unmarked).isEmpty();
    }

    @Test
    void whateverIsNotCheckedSaysWhy() throws IOException {
        List<String> silent = new ArrayList<>();
        for (Path source : sources()) {
            for (String line : Files.readAllLines(source)) {
                if (line.contains("\"NullAway") && !line.contains("// ")) {
                    silent.add(source + ": " + line.strip());
                }
            }
        }

        assertThat(silent).isEmpty();
    }

    private static List<Path> sources() {
        return SamiModule.built()
                .flatMap(module -> module.mainSources().stream())
                .toList();
    }

    private static String name(Path folder) {
        String path = folder.toString();
        return path.substring(path.indexOf("org/sami")).replace('/', '.');
    }
}
