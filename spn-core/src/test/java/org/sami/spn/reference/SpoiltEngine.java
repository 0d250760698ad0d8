package org.sami.spn.reference;

import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import org.sami.spn.model.Project;
import org.sami.spn.testing.SpoiltClasses;
import org.sami.spn.testing.TestVocabulary;

/** The engine with one line of its source changed, next to the right one. */
final class SpoiltEngine {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/spn/engine/rule");
    private static final String ENGINE = "org.sami.spn.engine.";

    private final SpoiltClasses classes;

    private SpoiltEngine(SpoiltClasses classes) {
        this.classes = classes;
    }

    /**
     * Compiles the engine with a change. The engine and what speaks to it come from there.
     *
     * @param file the source file, from the folder of the rules, such as {@code Firing.java}
     * @param right what stands there exactly once
     * @param wrong what is to stand there instead
     */
    static Differential.Maker with(Path folder, String file, String right, String wrong) {
        SpoiltEngine engine = new SpoiltEngine(SpoiltClasses.with(
                folder,
                SOURCES.resolve(file),
                right,
                wrong,
                name -> name.startsWith(ENGINE) || name.equals(EngineSubject.class.getName())));
        return engine::subject;
    }

    private Subject subject(Project project) {
        try {
            return (Subject) classes.loadClass(EngineSubject.class.getName())
                    .getConstructors()[0]
                    .newInstance(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
