package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The installed command says which libraries it contains and under which licences, and contains no others. */
@Tag("process")
class ThirdPartyNoticeTest {
    private static final Set<String> ALLOWED = Set.of(
            "Apache-2.0",
            "MIT",
            "BSD-2-Clause",
            "BSD-3-Clause",
            "EPL-1.0",
            "EPL-2.0",
            "LGPL-2.1-only",
            "LGPL-2.1-or-later",
            "LGPL-3.0-only",
            "LGPL-3.0-or-later");

    private static final Set<String> OWN = Set.of(
            "boat-link",
            "boat-mavlink",
            "crw-cli",
            "crw-domain",
            "crw-mavlink",
            "crw-report",
            "crw-services",
            "hull",
            "sami-mavlink",
            "crw-session",
            "crw-sim",
            "domain-config",
            "journal-postgres",
            "lessons",
            "net-picture",
            "pair-postgres",
            "petri",
            "server",
            "session-api",
            "session-client",
            "session-server",
            "spn-authoring",
            "spn-core",
            "spn-language",
            "uav-domain",
            "work-postgres");

    private static final Pattern ENTRY =
            Pattern.compile("^(\\S+) (\\S+)\\n    licence: (.+)\\n    home: (http\\S+)$", Pattern.MULTILINE);

    private final List<MatchResult> entries = ENTRY.matcher(notice()).results().toList();

    private static String notice() {
        try {
            return Files.readString(CrwProcess.INSTALLED.resolve("THIRD-PARTY.txt"));
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void namesEachLibraryOfTheDistributionWithItsVersion() throws Exception {
        List<String> jars;
        try (Stream<Path> lib = Files.list(CrwProcess.INSTALLED.resolve("lib"))) {
            jars = lib.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".jar"))
                    .filter(name -> OWN.stream().noneMatch(own -> name.matches(own + "-[0-9].*")))
                    .toList();
        }

        assertThat(jars).hasSizeGreaterThan(15);
        assertThat(entries)
                .extracting(entry -> entry.group(1) + "-" + entry.group(2) + ".jar")
                .containsExactlyInAnyOrderElementsOf(jars);
    }

    @Test
    void eachLicenceIsOneThatSamiAllowsItself() {
        assertThat(entries)
                .isNotEmpty()
                .allSatisfy(entry -> assertThat(ALLOWED)
                        .as(entry.group(1))
                        .containsAll(List.of(entry.group(3).split(" (?:AND|OR) "))));
    }

    @Test
    void samisOwnLicenceComesWithIt() {
        assertThat(CrwProcess.INSTALLED.resolve("LICENSE")).content().contains("Apache License");
    }
}
