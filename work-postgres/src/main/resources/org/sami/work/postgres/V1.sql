CREATE TABLE experiments (
    name text PRIMARY KEY,
    runs int NOT NULL,
    begun timestamptz NOT NULL DEFAULT clock_timestamp()
);
-- What results depend on: whoever joins has the same.
CREATE TABLE settings (
    experiment text NOT NULL REFERENCES experiments ON DELETE CASCADE,
    name text NOT NULL,
    value text NOT NULL,
    PRIMARY KEY (experiment, name)
);
-- Everybody who ever joined; who is there still renews the end of its lease.
CREATE TABLE workers (
    id bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    experiment text NOT NULL REFERENCES experiments ON DELETE CASCADE,
    name text NOT NULL,
    joined timestamptz NOT NULL DEFAULT clock_timestamp(),
    ends timestamptz NOT NULL
);
-- A run is free while it has no result and its lease is over; it counts how often it was begun and not given back.
CREATE TABLE runs (
    experiment text NOT NULL REFERENCES experiments ON DELETE CASCADE,
    run int NOT NULL,
    begun int NOT NULL DEFAULT 0,
    worker bigint REFERENCES workers ON DELETE SET NULL,
    ends timestamptz NOT NULL DEFAULT '-infinity',
    result text,
    PRIMARY KEY (experiment, run)
);
CREATE INDEX open_runs ON runs (experiment, run) WHERE result IS NULL;
