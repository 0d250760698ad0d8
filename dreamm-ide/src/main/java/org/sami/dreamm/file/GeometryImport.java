package org.sami.dreamm.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.geotext.GeoMeaning;
import org.sami.spn.geotext.GeoText;
import org.sami.spn.geotext.GeoTextReader;
import org.sami.spn.geotext.GeoVariables;
import org.sami.spn.geotext.LineFinding;
import org.sami.spn.geotext.ProjectVariables;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.model.VariableSpec;

/** Makes a variable of the project of a text file of positions; where brackets can mean several things, the author says what they mean. */
final class GeometryImport {
    private final DreammContext context;

    GeometryImport(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
    }

    /** Reads a file off the event thread, and goes on with what is in it. */
    void read(Path path) {
        context.background()
                .run(
                        "Reading " + path.getFileName(),
                        () -> {
                            try {
                                return GeoTextReader.read(BoundedFile.bytes(path, BoundedFile.DATA_BYTES));
                            } catch (IOException unreadable) {
                                throw new UncheckedIOException(path + " cannot be read", unreadable);
                            }
                        },
                        read -> askMeaning(path, read));
    }

    private void askMeaning(Path path, GeoTextReader.Result read) {
        if (read.text().isEmpty()) {
            refuse(path, read.findings());
            return;
        }
        GeoText text = read.text().get();
        List<AuthorQuestion.Choice> choices = GeoMeaning.of(text.nesting()).stream()
                .map(meaning -> new AuthorQuestion.Choice(
                        "geometry-" + meaning.word(), "As " + meaning.word(), () -> declare(path, text, meaning)))
                .toList();
        if (choices.size() == 1) {
            choices.get(0).chosen().run();
        } else {
            context.questions()
                    .ask(new AuthorQuestion(
                            "geometry-meaning",
                            path.getFileName() + " is " + text.words() + ": what is that?",
                            choices,
                            () -> {}));
        }
    }

    /** Declares the variable; one of its name that is there gets the new value, if it is of the same type. */
    void declare(Path path, GeoText text, GeoMeaning meaning) {
        String name = variableName(path);
        GeoVariables.Result made = GeoVariables.of(text, meaning, name, false);
        if (made.variables().isEmpty()) {
            refuse(path, made.findings());
            return;
        }
        List<String> there = ProjectVariables.collisions(context.document().project(), made.variables());
        List<Edit> edits = new ArrayList<>();
        for (VariableSpec variable : made.variables()) {
            edits.add(
                    there.contains(variable.name())
                            ? new VariableEdit.ChangeVariable(Optional.empty(), variable)
                            : new VariableEdit.AddVariable(Optional.empty(), variable));
        }
        context.apply(new EditSequence("Import " + path.getFileName() + " as " + name, edits));
    }

    private static String variableName(Path path) {
        String name = path.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        String letters = name.replaceAll("[^A-Za-z0-9_]+", "_").replaceFirst("^[^A-Za-z]+", "");
        return letters.isEmpty() ? "@imported" : "@" + letters;
    }

    private void refuse(Path path, List<LineFinding> findings) {
        context.notices()
                .refused(path.getFileName() + " is not imported: "
                        + findings.stream()
                                .filter(LineFinding::isError)
                                .findFirst()
                                .map(finding -> "line " + finding.line() + ": " + finding.message())
                                .orElse("it cannot be read"));
    }
}
