package org.sami.lessons.course;

import java.time.Duration;
import java.util.Collection;

/**
 * How long lessons take: their words at 200 a minute, half a minute a quiz, three minutes a job. The thesis's ten lessons took four and a half hours (9.3.1).
 */
public final class ReadingTime {
    private static final int WORDS_A_MINUTE = 200;
    private static final Duration A_QUIZ = Duration.ofSeconds(30);
    private static final Duration A_JOB = Duration.ofMinutes(3);

    private ReadingTime() {}

    /** The time that lessons take. */
    public static Duration of(Collection<Lesson> lessons) {
        return lessons.stream().map(ReadingTime::of).reduce(Duration.ZERO, Duration::plus);
    }

    /** The time that a lesson takes. */
    public static Duration of(Lesson lesson) {
        Duration time = Duration.ZERO;
        int words = 0;
        for (Step step : lesson.steps()) {
            words += Paragraph.count(step.text());
            if (step instanceof Step.Quiz quiz) {
                time = time.plus(A_QUIZ);
                words += wordsOf(quiz.ask());
            } else if (step instanceof Step.Job) {
                time = time.plus(A_JOB);
            }
        }
        return time.plusSeconds(Math.round(words * 60.0 / WORDS_A_MINUTE));
    }

    private static int wordsOf(QuizQuestion ask) {
        if (ask instanceof QuizQuestion.One one) {
            return Paragraph.count(
                    one.choices().stream().map(QuizQuestion.Choice::text).toList());
        }
        return ask instanceof QuizQuestion.Several several
                ? Paragraph.count(several.choices().stream()
                        .map(QuizQuestion.Choice::text)
                        .toList())
                : 0;
    }
}
