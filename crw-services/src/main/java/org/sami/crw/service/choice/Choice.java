package org.sami.crw.service.choice;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Which algorithm solves a problem, by what the algorithms declare, and why that one.
 *
 * @param ranked those that can be used for the problem, the chosen one first
 * @param reason a sentence for people
 */
public record Choice<A>(List<A> ranked, String reason) {
    private static final Comparator<Optional<Merit>> BEST_FIRST = Comparator.comparing(
            (Optional<Merit> merit) -> merit.orElse(null), Comparator.nullsLast(Comparator.reverseOrder()));

    public Choice {
        ranked = List.copyOf(ranked);
        if (ranked.isEmpty()) {
            throw new IllegalArgumentException("A choice of none");
        }
    }

    /** The chosen algorithm. */
    public A first() {
        return ranked.get(0);
    }

    /**
     * Chooses the algorithm that serves a criterion best; of those that serve it equally, and without a criterion, the earlier one.
     *
     * @throws IllegalArgumentException where none can be used for the problem; says why of each
     */
    public static <P, A extends DeclaredAlgorithm<P>> Choice<A> of(
            List<A> algorithms, P problem, Optional<Criterion> criterion) {
        List<A> able = new ArrayList<>();
        List<String> unable = new ArrayList<>();
        for (A algorithm : algorithms) {
            algorithm
                    .whyNot(problem)
                    .ifPresentOrElse(
                            why -> unable.add("not " + algorithm.name() + ": " + why), () -> able.add(algorithm));
        }
        if (able.isEmpty()) {
            throw new IllegalArgumentException(String.join("; ", unable));
        }
        criterion.ifPresent(wanted -> able.sort(
                Comparator.comparing((A a) -> Optional.ofNullable(a.serves().get(wanted)), BEST_FIRST)));
        List<String> words = new ArrayList<>();
        words.add(chosen(able.get(0), criterion));
        criterion.ifPresent(wanted -> words.addAll(others(able, wanted)));
        words.addAll(unable);
        return new Choice<>(able, String.join("; ", words));
    }

    private static String chosen(DeclaredAlgorithm<?> first, Optional<Criterion> criterion) {
        return criterion
                .map(wanted -> first.name()
                        + Optional.ofNullable(first.serves().get(wanted))
                                .map(merit -> ", " + merit.words() + " for " + wanted.words())
                                .orElse(", as none says that it serves " + wanted.words()))
                .orElse(first.name() + ", the standard, as no criterion was given");
    }

    /** Those that serve the criterion less well; not those that say nothing of it. */
    private static <A extends DeclaredAlgorithm<?>> List<String> others(List<A> able, Criterion wanted) {
        return able.stream()
                .skip(1)
                .filter(other -> other.serves().containsKey(wanted))
                .map(other -> other.name() + " is " + other.serves().get(wanted).words() + " for it")
                .toList();
    }
}
