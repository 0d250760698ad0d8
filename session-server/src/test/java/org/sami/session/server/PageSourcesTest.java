package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the build's TypeScript compiler does with sources of a page: a wrong type is found, and browsers get modules. */
@Tag("long")
class PageSourcesTest {
    private static final String BOAT = "export interface Boat {\n  id: string;\n  speed?: number;\n}\n";

    /** With no types of browsers, which take most of the time. */
    private static final String OPTIONS = """
        {"compilerOptions": {"target": "ES2021", "module": "ES2020", "moduleResolution": "Bundler", "lib": ["ES5"],
          "types": [], "strict": true, "verbatimModuleSyntax": true}}
        """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeProtocol() throws IOException {
        write("tsconfig.json", OPTIONS);
        write("protocol.ts", BOAT);
    }

    @Test
    void eachWrongTypeIsNamedByFileLineAndColumnAndNothingIsMade() throws Exception {
        write("page.ts", """
            import type {Boat} from './protocol.js';

            export function words(boat: Boat) {
              return boat.sped + boat.speed.toFixed(1);
            }
            """);
        write("list.ts", "export const length: string = [].length;\n");

        Ended ended = compile();

        assertThat(ended.code).isEqualTo(1);
        assertThat(ended.said.lines())
                .containsExactly(
                        "list.ts(1,14): Type 'number' is not assignable to type 'string'.",
                        "page.ts(4,15): Property 'sped' does not exist on type 'Boat'. Did you mean 'speed'?",
                        "page.ts(4,22): 'boat.speed' is possibly 'undefined'.");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @Test
    void rightSourcesBecomeModulesAndTypesAloneBecomeNone() throws Exception {
        write("page.ts", """
            import type {Boat} from './protocol.js';
            import {unit} from './parts/unit.js';

            // Says what a boat does.
            export function words(boat: Boat): string {
              return boat.id + (boat.speed ?? '?') + unit;
            }
            """);
        write("parts/unit.ts", "export const unit = 'm/s' as const;\n");

        Ended ended = compile();

        assertThat(ended.said).isEmpty();
        assertThat(ended.code).isZero();
        try (Stream<Path> made = Files.walk(folder.resolve("out"))) {
            assertThat(made.filter(Files::isRegularFile)
                            .map(file -> folder.resolve("out").relativize(file).toString()))
                    .containsExactlyInAnyOrder("page.js", "parts/unit.js");
        }
        assertThat(Files.readString(folder.resolve("out/page.js"))).isEqualTo("""
            import { unit } from './parts/unit.js';
            // Says what a boat does.
            export function words(boat) {
                return boat.id + (boat.speed ?? '?') + unit;
            }
            """);
    }

    private record Ended(int code, String said) {}

    private Ended compile() throws IOException, InterruptedException {
        String classPath = System.getProperty("typescript.compiler");
        assumeTrue(classPath != null, "the build says where its compiler is: ./gradlew :session-server:longTest");
        Path said = folder.resolve("said");
        Process process = new ProcessBuilder(List.of(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx640m",
                        "-cp",
                        classPath,
                        "org.sami.house.typescript.TypeScriptCompiler",
                        folder.resolve("sources").toString(),
                        folder.resolve("out").toString()))
                .redirectErrorStream(true)
                .redirectOutput(said.toFile())
                .start();
        int code = process.waitFor();
        return new Ended(code, Files.readString(said, StandardCharsets.UTF_8));
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.resolve("sources").resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
