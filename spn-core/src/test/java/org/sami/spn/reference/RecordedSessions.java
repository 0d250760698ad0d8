package org.sami.spn.reference;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.RuleVersion;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.ProtocolJson;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.testing.TestVocabulary;

/**
 * Sessions with the hash of what the engine did, recorded for one version of its rules: a project in a line, then the inputs with their times,
 * then the hash. When the version rises, {@link #main} records others; those of before stay.
 */
final class RecordedSessions {
    private static final int COUNT = 8;
    private static final int INPUTS = 60;
    private static final Path RESOURCES = Path.of("src/test/resources");

    /** One session. */
    record Recorded(Project project, List<Scenario.Timed> inputs, String hash) {}

    private RecordedSessions() {}

    private static String file(int version) {
        return "/org/sami/spn/reference/rules-" + version + ".txt";
    }

    static List<Recorded> of(int version) throws Exception {
        List<Recorded> sessions = new ArrayList<>();
        try (InputStream in = RecordedSessions.class.getResourceAsStream(file(version))) {
            Project project = null;
            List<Scenario.Timed> inputs = new ArrayList<>();
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
                String[] parts = line.split(" ", 2);
                if (parts[0].equals("project")) {
                    project = new ProjectReader(TestVocabulary.TEST)
                            .read(parts[1])
                            .orThrow();
                } else if (parts[0].equals("hash")) {
                    sessions.add(new Recorded(project, List.copyOf(inputs), parts[1]));
                    inputs.clear();
                } else {
                    inputs.add(new Scenario.Timed(Long.parseLong(parts[0]), ProtocolJson.readInput(parts[1])));
                }
            }
        }
        return sessions;
    }

    /** SHA-256 over the firings, activations and ends that follow from inputs. */
    static String hash(Project project, List<Scenario.Timed> inputs) {
        Engine engine = new Engine(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
        EngineState state = engine.newState();
        MessageDigest digest = sha256();
        for (Scenario.Timed timed : inputs) {
            for (Effect effect : engine.step(state, timed.nowMillis(), timed.input())) {
                if (effect instanceof Effect.Fired
                        || effect instanceof Effect.Activated
                        || effect instanceof Effect.MissionEnded) {
                    digest.update(ProtocolJson.effect(effect).toString().getBytes(StandardCharsets.UTF_8));
                }
            }
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Records sessions of this program's version, in which robots are gone while something asks for them; not over others. */
    public static void main(String[] args) throws IOException {
        Path file = Path.of(args.length > 0 ? args[0] : RESOURCES + file(RuleVersion.CURRENT));
        if (Files.exists(file)) {
            throw new IOException(file + " is there already: rules that changed have a new version");
        }
        StringBuilder text = new StringBuilder();
        int recorded = 0;
        for (long seed = 1; recorded < COUNT; seed++) {
            Optional<Project> readable = RandomLoads.readable(RandomPlans.project(seed));
            if (readable.isEmpty()) {
                continue;
            }
            Project project = readable.get();
            RandomInputs world = new RandomInputs(project, seed);
            Subject interpreter = Differential.interpreter(project);
            List<Scenario.Timed> inputs = new ArrayList<>();
            boolean gone = false;
            for (int i = 0; i < INPUTS; i++) {
                Scenario.Timed timed = world.next(interpreter);
                inputs.add(timed);
                List<Effect> effects = interpreter.step(timed.nowMillis(), timed.input());
                world.saw(effects);
                gone |= effects.stream()
                        .anyMatch(e -> e instanceof Effect.Noted noted && noted.kind() == NoteKind.GONE);
            }
            if (gone) {
                String document =
                        new ProjectWriter(TestVocabulary.TEST).text(project).replaceAll("\\s*\\n\\s*", " ");
                text.append("project ").append(document).append('\n');
                inputs.forEach(timed -> text.append(timed.nowMillis())
                        .append(' ')
                        .append(ProtocolJson.inputText(timed.input()))
                        .append('\n'));
                Project read =
                        new ProjectReader(TestVocabulary.TEST).read(document).orThrow();
                text.append("hash ").append(hash(read, inputs)).append('\n');
                recorded++;
            }
        }
        Files.createDirectories(file.getParent());
        Files.writeString(file, text.toString());
    }
}
