package org.sami.lessons.site;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.LessonJson;
import org.sami.lessons.course.Paragraph;
import org.sami.lessons.course.Picture;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.ReadingTime;
import org.sami.lessons.course.Response;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.Term;
import org.sami.lessons.course.TokensAt;
import org.sami.lessons.site.LessonPage.FieldPart;
import org.sami.lessons.site.LessonPage.JobPart;
import org.sami.lessons.site.LessonPage.ParagraphPart;
import org.sami.lessons.site.LessonPage.SpanPart;
import org.sami.lessons.site.LessonPage.StepPart;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/** Turns lessons into what the templates of pages read. */
final class LessonPages {
    private final Course course;
    private final Vocabulary vocabulary;

    LessonPages(Course course, Vocabulary vocabulary) {
        this.course = Objects.requireNonNull(course, "course");
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    LessonPage page(Lesson lesson) {
        return new LessonPage(
                lesson.id(),
                lesson.heading(),
                lesson.summary(),
                minutes(ReadingTime.of(lesson)),
                lesson.steps().stream().map(step -> step(lesson, step)).toList(),
                course.before(lesson.id()).map(Lesson::id).orElse(""),
                course.after(lesson.id()).map(Lesson::id).orElse(""));
    }

    static long minutes(Duration time) {
        return Math.max(1, Math.round(time.toSeconds() / 60.0));
    }

    /**
     * The file of a plan, below the pages.
     *
     * @param key as in {@link Course#plans}
     */
    static String planFile(String key) {
        return "plans/" + key.replace('/', '-') + ".json";
    }

    private StepPart step(Lesson lesson, Step step) {
        Optional<Picture> picture = step.picture().or(() -> drawn(step));
        return new StepPart(
                step.id(),
                kind(step),
                step.title(),
                paragraphs(step.text()),
                picture.map(one -> svg(lesson, one)).orElse(""),
                picture.map(Picture::caption).orElse(""),
                step instanceof Step.Show show ? said(show) : List.of(),
                step instanceof Step.Quiz quiz ? question(lesson, quiz) : "",
                step instanceof Step.Quiz quiz ? fields(lesson, quiz) : List.of(),
                step instanceof Step.Quiz quiz ? explained(lesson, quiz) : "",
                step instanceof Step.Job job ? job(lesson, job) : JobPart.NONE);
    }

    /** What DREAMM plays in its editor: where it leads, for who reads. */
    private static Optional<Picture> drawn(Step step) {
        if (step instanceof Step.Show show) {
            return show.result().map(result -> new Picture(result, List.of(), List.of(), "What it leads to"));
        }
        return step instanceof Step.Play play
                ? Optional.of(new Picture(play.plan(), List.of(), List.of(), ""))
                : Optional.empty();
    }

    private static List<String> said(Step.Show show) {
        return show.script().stream()
                .map(element -> element.path("say").asText())
                .filter(sentence -> !sentence.isBlank())
                .toList();
    }

    private List<ParagraphPart> paragraphs(List<String> text) {
        return text.stream().map(Paragraph::of).map(this::paragraph).toList();
    }

    private static String kind(Step step) {
        if (step instanceof Step.Quiz) {
            return "quiz";
        } else if (step instanceof Step.Job) {
            return "job";
        } else if (step instanceof Step.Show) {
            return "show";
        }
        return step instanceof Step.Play ? "play" : "text";
    }

    private ParagraphPart paragraph(Paragraph paragraph) {
        return new ParagraphPart(
                paragraph.isItem(), paragraph.spans().stream().map(this::span).toList());
    }

    private SpanPart span(Paragraph.Span span) {
        if (span instanceof Paragraph.Span.TermLink link) {
            String help = course.term(link.term()).map(Term::text).orElse("");
            String id = course.term(link.term()).map(Term::id).orElse("");
            return new SpanPart("term", link.words(), id, help);
        }
        return new SpanPart(span instanceof Paragraph.Span.Bold ? "bold" : "plain", span.words(), "", "");
    }

    private String svg(Lesson lesson, Picture picture) {
        Plan plan = course.plan(lesson.id(), picture.plan()).orElseThrow();
        String document = StepPicture.svg(plan, vocabulary, picture);
        return document.substring(document.indexOf("<svg"));
    }

    private String explained(Lesson lesson, Step.Quiz quiz) {
        return course.address(lesson.id(), quiz.explained())
                .map(address -> address.lesson() + ".html#" + address.step())
                .orElse("");
    }

    private JobPart job(Lesson lesson, Step.Job job) {
        JsonNode file = LessonJson.read(
                        job.job(), course.jobs().getOrDefault(lesson.id() + "/" + job.job(), "{}"), JsonNode.class)
                .orThrow();
        List<String> hints = new ArrayList<>();
        file.path("hints").forEach(hint -> hints.add(hint.asText()));
        String key = Course.fileOf(lesson.id(), file.path("start").asText());
        JsonNode example = file.path("example");
        List<String> text = new ArrayList<>();
        example.path("text").forEach(paragraph -> text.add(paragraph.asText()));
        String svg = example.path("plan").isTextual()
                ? svg(lesson, new Picture(example.path("plan").asText(), List.of(), List.of(), ""))
                : "";
        return new JobPart(key, planFile(key), hints, paragraphs(text), svg);
    }

    /**
     * A quiz as the page's script reads it.
     *
     * @param right where tokens are to be put, where it asks that
     */
    record QuizData(QuizQuestion ask, String solved, List<TokensAt> right) {}

    /** The quiz as the page's script reads it. */
    private String question(Lesson lesson, Step.Quiz quiz) {
        Response right = new QuizGrader(course, vocabulary).right(lesson, quiz);
        List<TokensAt> tokens = right instanceof Response.Tokens put ? put.tokens() : List.of();
        QuizData asked = new QuizData(quiz.ask(), quiz.solved(), tokens);
        return LessonJson.write(asked).replace("<", "\\u003c");
    }

    private List<FieldPart> fields(Lesson lesson, Step.Quiz quiz) {
        QuizQuestion ask = quiz.ask();
        if (ask instanceof QuizQuestion.One one) {
            return choices(one.choices(), "radio");
        } else if (ask instanceof QuizQuestion.Several several) {
            return choices(several.choices(), "checkbox");
        } else if (ask instanceof QuizQuestion.Amount amount) {
            return List.of(new FieldPart("number", "number", amount.unit()));
        }
        Plan plan =
                course.plan(lesson.id(), quiz.picture().orElseThrow().plan()).orElseThrow();
        return ask instanceof QuizQuestion.Mark mark ? elements(plan, mark) : tokens(lesson, quiz, plan);
    }

    private static List<FieldPart> choices(List<QuizQuestion.Choice> choices, String type) {
        List<FieldPart> fields = new ArrayList<>();
        for (int i = 0; i < choices.size(); i++) {
            fields.add(new FieldPart(type, String.valueOf(i), choices.get(i).text()));
        }
        return fields;
    }

    private List<FieldPart> elements(Plan plan, QuizQuestion.Mark mark) {
        Stream<String> places = plan.places().stream().map(place -> place.id());
        Stream<String> transitions = plan.transitions().stream().map(transition -> transition.id());
        Stream<String> edges = Stream.concat(
                plan.inEdges().stream().map(edge -> edge.id()),
                plan.outEdges().stream().map(edge -> edge.id()));
        Stream<String> ids = switch (mark.of()) {
            case PLACES -> places;
            case TRANSITIONS -> transitions;
            case EDGES -> edges;
            case ELEMENTS -> Stream.of(places, transitions, edges).flatMap(each -> each);
        };
        ElementNames names = new ElementNames(plan, vocabulary);
        return ids.map(id -> new FieldPart("checkbox", id, names.of(id).orElse(id)))
                .toList();
    }

    /** A number of generic tokens for each place, and a box for each robot and task that stands anywhere in the question. */
    private List<FieldPart> tokens(Lesson lesson, Step.Quiz quiz, Plan plan) {
        Response.Tokens right = (Response.Tokens) new QuizGrader(course, vocabulary).right(lesson, quiz);
        List<TokensAt> all = Stream.concat(quiz.picture().orElseThrow().tokens().stream(), right.tokens().stream())
                .toList();
        List<String> robots = all.stream()
                .flatMap(at -> at.robots().stream())
                .distinct()
                .sorted()
                .toList();
        List<String> tasks = all.stream()
                .flatMap(at -> at.tasks().stream())
                .distinct()
                .sorted()
                .toList();
        boolean generic = all.stream().anyMatch(at -> at.generic() > 0);
        ElementNames names = new ElementNames(plan, vocabulary);
        List<FieldPart> fields = new ArrayList<>();
        plan.places().forEach(place -> {
            String name = names.of(place.id()).orElse(place.id());
            if (generic) {
                fields.add(new FieldPart("number", place.id() + "|generic", name + ": generic tokens"));
            }
            robots.forEach(robot ->
                    fields.add(new FieldPart("checkbox", place.id() + "|robot|" + robot, name + ": " + robot)));
            tasks.forEach(
                    task -> fields.add(new FieldPart("checkbox", place.id() + "|task|" + task, name + ": " + task)));
        });
        return fields;
    }
}
