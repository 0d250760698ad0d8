CREATE TABLE header (
    pos bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    kind text NOT NULL,
    name text NOT NULL,
    content text NOT NULL
);
CREATE TABLE entries (
    idx bigint PRIMARY KEY,
    at_millis bigint NOT NULL,
    input text NOT NULL,
    checksum bytea NOT NULL
);
CREATE TABLE snapshots (
    idx bigint PRIMARY KEY,
    state bytea NOT NULL,
    checksum bytea NOT NULL
);
CREATE TABLE marks (
    idx bigint PRIMARY KEY,
    mark text NOT NULL,
    checksum bytea NOT NULL
);
CREATE TABLE documents (
    sha256 text PRIMARY KEY,
    content text NOT NULL
);
CREATE TABLE telemetry (
    pos bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    at_millis bigint NOT NULL,
    proxy text NOT NULL,
    kind text NOT NULL,
    json text NOT NULL,
    sum bigint NOT NULL
);
-- Entries behind the last valid one of a damaged journal, as they were found.
CREATE TABLE set_aside (
    at timestamptz NOT NULL,
    idx bigint NOT NULL,
    at_millis bigint NOT NULL,
    input text NOT NULL,
    checksum bytea NOT NULL
);
-- One row: who may write. A base that takes over changes the key, so that its update waits for appends under way and fails those behind it.
CREATE TABLE lease (
    epoch bigint PRIMARY KEY,
    only_row boolean NOT NULL DEFAULT true UNIQUE CHECK (only_row),
    holder text NOT NULL,
    taken timestamptz NOT NULL,
    ends timestamptz NOT NULL
);
-- Everybody who ever held it.
CREATE TABLE holders (
    epoch bigint PRIMARY KEY,
    holder text NOT NULL,
    taken timestamptz NOT NULL
);
INSERT INTO lease (epoch, holder, taken, ends) VALUES (0, '', clock_timestamp(), clock_timestamp());
