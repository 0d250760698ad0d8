package org.sami.spn.suggestion;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/** What it means to a plan that a finding goes or comes, in a short sentence. */
final class FindingWords {
    private final Plan plan;
    private final ElementNames names;

    FindingWords(Plan plan, Vocabulary vocabulary) {
        this.plan = plan;
        names = new ElementNames(plan, vocabulary);
    }

    /** The sentences for findings that go; one for all places that can be entered now, and one for all transitions that can fire now. */
    List<String> mended(List<Finding> findings) {
        return lines(findings, false);
    }

    /** The sentences for findings that come. */
    List<String> caused(List<Finding> findings) {
        return lines(findings, true);
    }

    private List<String> lines(List<Finding> findings, boolean come) {
        List<String> lines = new ArrayList<>();
        List<String> places = unreached(findings, id -> plan.place(id).isPresent());
        List<String> transitions = unreached(findings, id -> plan.transition(id).isPresent());
        findings.stream()
                .filter(finding -> !isUnreached(finding))
                .forEach(finding -> lines.add(sentence(finding, come)));
        if (!places.isEmpty()) {
            String are = places.size() == 1 ? " is" : " are";
            lines.add(String.join(", ", places) + (come ? are + " never entered" : " can be entered"));
        }
        if (!transitions.isEmpty()) {
            String fire = transitions.size() == 1 ? " never fires" : " never fire";
            lines.add(String.join(", ", transitions) + (come ? fire : " can fire"));
        }
        return lines;
    }

    private List<String> unreached(List<Finding> findings, Predicate<String> kind) {
        return findings.stream()
                .filter(this::isUnreached)
                .map(finding -> finding.elements().get(0))
                .filter(kind)
                .map(this::word)
                .toList();
    }

    private boolean isUnreached(Finding finding) {
        return VersionFindings.code(finding).equals("W-NEVER-REACHED")
                && finding.plan().equals(plan.id())
                && !finding.elements().isEmpty();
    }

    private String sentence(Finding finding, boolean comes) {
        List<String> about = finding.elements();
        String never = comes ? " " : " no longer ";
        if (about.isEmpty() || !finding.plan().equals(plan.id())) {
            return (comes ? "New: " : "Mended: ") + finding.message();
        }
        String first = word(about.get(0));
        String last = word(about.get(about.size() - 1));
        return switch (VersionFindings.code(finding)) {
            case "W-STUCK" ->
                "The mission" + never + "stands still with tokens in "
                        + about.stream().map(this::word).collect(Collectors.joining(", "));
            case "W-ENDS-EARLY" -> last + never + "ends the mission while somebody is under way in " + first;
            case "W-LEFT-OUT" -> last + never + "leaves somebody out in " + first;
            case "W-FORGOTTEN" -> last + never + "forgets somebody in " + first;
            case "W-PILES-UP" -> "Tokens" + never + "pile up in " + first;
            case "W-WAITS-FOR-NOBODY" ->
                comes ? "Nobody ever waits in " + first : "Who comes to " + first + " waits there for the others";
            default -> (comes ? "New: " : "Mended: ") + finding.message();
        };
    }

    private String word(String element) {
        return plan.place(element)
                .map(names::inSentence)
                .or(() -> plan.transition(element).map(names::inSentence))
                .orElse("\"" + element + "\"");
    }
}
