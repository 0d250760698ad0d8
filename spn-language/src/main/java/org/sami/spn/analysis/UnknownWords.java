package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.Edit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.value.TextValue;

/**
 * A text whose words the domain lists, such as the name of a sensor, is one of them, or ends with one after a slash: a robot may tell
 * its instruments apart.
 */
final class UnknownWords implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-UNKNOWN-WORD",
                "No robot of this domain knows the word, such as a sensor that none has: nothing is measured.",
                "Choose one of the words that the message names."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (KnownFields.Known known : plan.known().all()) {
            List<String> words = known.field().limits().words();
            if (!words.isEmpty() && known.value() instanceof TextValue text) {
                String word = text.value().substring(text.value().lastIndexOf('/') + 1);
                if (!word.isBlank() && !words.contains(word)) {
                    report(known, text.value(), word, words, report);
                }
            }
        }
    }

    private static void report(
            KnownFields.Known known, String text, String word, List<String> words, Consumer<Finding> report) {
        Finding finding = Finding.warning(
                "W-UNKNOWN-WORD",
                known.pointer(),
                known.name() + " is \"" + text + "\"; known are " + String.join(", ", words)
                        + Suggestions.meant(words, word),
                known.vertex(),
                known.event());
        for (String meant : Suggestions.alike(words, word)) {
            Optional<Edit> edit = known.rewriting().apply(new TextValue(meant));
            if (edit.isPresent()) {
                finding = finding.fixedBy("Write " + meant, edit.get());
            }
        }
        report.accept(finding);
    }
}
